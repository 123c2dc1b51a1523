// SPDX-License-Identifier: MIT
/// The largest alpha around a point of a map: tells which texels of a light map hold any skin that the alpha
/// test keeps. A mean, as in mip levels, would lose parts thinner than its texels.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"

namespace dermis::passes {

/// Level 0 is the alpha of the picture; each further level has half the size (rounded down, at least 1), as
/// mip levels have. A texel holds the largest alpha of all pixels that it covers, even partly.
struct AlphaLevels {
  std::uint32_t count = 0;
  std::vector<std::uint8_t> bytes;  ///< one level after the other, rows tightly packed
};
/// Returns the levels of a picture of at least one pixel.
AlphaLevels alpha_max_levels(const image::Image8& picture);

}  // namespace dermis::passes
