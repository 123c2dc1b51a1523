// SPDX-License-Identifier: MIT
/// Scattering in screen space from a disc of taps around each pixel, with a fixed number of taps and without
/// history. README.md says what it cannot do.
/// Based on: [CB15] Christensen, Burley: Approximate Reflectance Profiles for Efficient Subsurface
/// Scattering.
///           Pixar TM 15-04, 2015
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {

extern const Technique burley_disc;

}  // namespace dermis::techniques
