// SPDX-License-Identifier: MIT
// Shows errors as colours.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

/// Returns the sRGB display value of the colour map magma, t = 0 (black) to 1 (pale yellow), clamped; NaN
/// gives 0. Brightness grows evenly with t. Keeps every 17th entry of the map of van der Walt, Smith: the
/// default colour maps of matplotlib 2.0, 2015 (CC0), and is within 3/255 of it.
std::array<std::uint8_t, 3> magma(float t);

/// Returns a map of 1 channel, 0 to full_scale, in magma. Pixels outside of the region (empty: all inside)
/// are grey.
Image8 error_colours(const ImageF& map, float full_scale, std::span<const std::uint8_t> region = {});

}  // namespace dermis::image
