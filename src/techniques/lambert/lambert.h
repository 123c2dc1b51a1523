// SPDX-License-Identifier: MIT
/// Skin as an opaque surface: what scattering is compared with, and the floor of what a frame costs.
#pragma once

#include "techniques/technique.h"

namespace dermis::techniques {

extern const Technique lambert;

}  // namespace dermis::techniques
