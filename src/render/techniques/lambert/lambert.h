// SPDX-License-Identifier: MIT
/// Skin as an opaque surface, without scattering. The smallest technique: pictures with scattering are
/// compared with it, and no frame costs less.
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {

extern const Technique lambert;

}  // namespace dermis::techniques
