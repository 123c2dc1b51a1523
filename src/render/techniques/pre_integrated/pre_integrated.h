// SPDX-License-Identifier: MIT
/// Scattering integrated beforehand, in tables over the light's angle and the skin's curvature. Based on:
/// Penner: Pre-Integrated Skin Shading. GPU Pro 2, 2011, in the form of NVIDIA FaceWorks.
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {
extern const Technique pre_integrated;
}  // namespace dermis::techniques
