// SPDX-License-Identifier: MIT
// Distances between two pictures.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"

namespace dermis::image {

inline constexpr double psnr_cap_db = 100;

/// Returns 10 log10(255^2 / mean squared difference) of the R, G and B display values, at most 100 (equal
/// pictures). Alpha does not count. mask: empty (all pixels count) or one byte per pixel, 0 = does not count.
/// Throws InputError for different sizes, a mask of another size, a mask without a pixel.
double psnr_db(const Image8& a, const Image8& b, std::span<const std::uint8_t> mask = {});

/// Returns the squared difference divided by the squared reference plus 0.01, averaged over pixels and R, G
/// and B of two linear pictures of 3 or 4 channels. The 0.01 keeps black pixels from dominating. All
/// brightnesses count equally; not symmetric. mask and InputError as above. Based on: Rousselle, Knaus,
/// Zwicker: Adaptive Sampling and Reconstruction using Greedy Error Minimization. SIGGRAPH Asia 2011
double rel_mse(const ImageF& reference, const ImageF& test, std::span<const std::uint8_t> mask = {});

/// Returns an estimate of the rel_mse() that a reference without noise would give, from one whose `variance`
/// (squared standard error, per value) is known; below 0 by chance. A pixel's difference is divided by the
/// mean of its neighbours within `around`, not by its own value, whose noise is also in the difference.
/// Divided by its own value, of relative noise s, the figure would be least for a picture of 1 - 2 s^2 times
/// the truth. mask as above; `around` has a byte per pixel, and a pixel without neighbours there counts by
/// its own value.
double rel_mse_less_noise(const ImageF& reference, const ImageF& variance, const ImageF& test,
                          std::span<const std::uint8_t> mask, std::span<const std::uint8_t> around);

}  // namespace dermis::image
