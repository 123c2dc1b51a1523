// SPDX-License-Identifier: MIT
/// Light blurred in the picture by each Gaussian of the profile. Based on: Jimenez, Sundstedt, Gutierrez:
/// Screen-Space Perceptual Rendering of Human Skin. ACM Transactions on Applied Perception 6(4), 2009.
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {
extern const Technique screen_gaussians;
}  // namespace dermis::techniques
