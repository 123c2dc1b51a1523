// SPDX-License-Identifier: MIT
// How far two pictures are apart.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

inline constexpr double psnr_cap_db = 100;

/// 10 log10(255^2 / mean squared difference) of the R, G and B display values, capped at 100 (equal pictures). Alpha does not count.
/// mask: empty (all pixels count) or one byte a pixel, 0 = does not count.
/// InputError: pictures of different sizes, a mask of another size, a mask that selects no pixel.
double psnr_db(const Image8& a, const Image8& b, std::span<const std::uint8_t> mask = {});

}  // namespace dermis::image
