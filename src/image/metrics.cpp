// SPDX-License-Identifier: MIT
#include "image/metrics.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/error.h"

namespace dermis::image {

double psnr_db(const Image8& a, const Image8& b, std::span<const std::uint8_t> mask) {
  if (a.width != b.width || a.height != b.height) {
    throw input_error("", "pictures of different sizes cannot be compared: {} x {} and {} x {} pixels", a.width, a.height, b.width,
                      b.height);
  }
  DERMIS_ASSERT_EQ(a.rgba.size(), b.rgba.size());
  const std::size_t pixels = a.rgba.size() / 4;
  if (!mask.empty() && mask.size() != pixels) throw input_error("", "the mask has {} pixels, the pictures have {}", mask.size(), pixels);
  // Whole numbers: the sum is exact, whatever the order.
  std::uint64_t sum = 0;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    ++count;
    for (std::size_t c = 0; c < 3; ++c) {
      const int difference = int{a.rgba[i * 4 + c]} - int{b.rgba[i * 4 + c]};
      sum += static_cast<std::uint64_t>(difference * difference);
    }
  }
  if (count == 0) throw input_error("", "no pixel to compare: the mask selects none");
  if (sum == 0) return psnr_cap_db;
  const double mean = static_cast<double>(sum) / (3.0 * static_cast<double>(count));
  return std::min(psnr_cap_db, 10 * std::log10(255.0 * 255.0 / mean));
}

}  // namespace dermis::image
