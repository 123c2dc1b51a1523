// SPDX-License-Identifier: MIT
// How far two pictures are apart.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

inline constexpr double psnr_cap_db = 100;

/// 10 log10(255^2 / mean squared difference) of the R, G and B display values, capped at 100 (equal
/// pictures). Alpha does not count. mask: empty (all pixels count) or one byte per pixel, 0 = does not count.
/// InputError: pictures of different sizes, a mask of another size, a mask that selects no pixel.
double psnr_db(const Image8& a, const Image8& b, std::span<const std::uint8_t> mask = {});

/// The squared difference divided by the squared reference plus 0.01 (so that black does not rule), averaged
/// over pixels and R, G and B of two linear pictures of 3 or 4 channels. Every brightness counts alike; not
/// symmetric. mask and InputError as above. Based on: Rousselle, Knaus, Zwicker: Adaptive Sampling and
/// Reconstruction using Greedy Error Minimization. SIGGRAPH Asia 2011
double rel_mse(const ImageF& reference, const ImageF& test, std::span<const std::uint8_t> mask = {});

}  // namespace dermis::image
