// SPDX-License-Identifier: MIT
// Errors as colours.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

/// sRGB display values of the colour map magma, t = 0 (black) to 1 (pale yellow), clamped; NaN gives 0.
/// Brightness grows evenly with t. Within 3/255 of van der Walt, Smith: the default colour maps of
/// matplotlib 2.0, 2015 (CC0), of which it keeps every 17th entry.
std::array<std::uint8_t, 3> magma(float t);

/// A map of 1 channel, 0 to full_scale, as magma. Pixels outside of the region (empty: none) are grey.
Image8 error_colours(const ImageF& map, float full_scale, std::span<const std::uint8_t> region = {});

}  // namespace dermis::image
