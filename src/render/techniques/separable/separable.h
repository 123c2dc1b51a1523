// SPDX-License-Identifier: MIT
/// Separable scattering in screen space: two passes of one dimension over the picture. README.md says what it
/// cannot do.
/// Based on: [JZJ15] Jimenez, Zsolnai, Jarabo et al.: Separable Subsurface Scattering. CGF 34(6), 2015
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {

extern const Technique separable;

}  // namespace dermis::techniques
