// SPDX-License-Identifier: MIT
#include "image/metrics.h"

#include <algorithm>
#include <cmath>

#include "core/assert.h"
#include "core/error.h"

namespace dermis::image {

namespace {

template <class Image>
std::size_t check_sizes(const Image& a, const Image& b, std::span<const std::uint8_t> mask) {
  if (a.width != b.width || a.height != b.height) {
    throw input_error("", "pictures of different sizes cannot be compared: {} x {} and {} x {} pixels",
                      a.width, a.height, b.width, b.height);
  }
  const std::size_t pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
  if (!mask.empty() && mask.size() != pixels)
    throw input_error("", "the mask has {} pixels, the pictures have {}", mask.size(), pixels);
  return pixels;
}

}  // namespace

double psnr_db(const Image8& a, const Image8& b, std::span<const std::uint8_t> mask) {
  const std::size_t pixels = check_sizes(a, b, mask);
  DERMIS_ASSERT_EQ(a.rgba.size(), b.rgba.size());
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

double rel_mse(const ImageF& reference, const ImageF& test, std::span<const std::uint8_t> mask) {
  constexpr double floor = 0.01;
  const std::size_t pixels = check_sizes(reference, test, mask);
  DERMIS_ASSERT_LE(3, reference.channels);
  DERMIS_ASSERT_LE(3, test.channels);

  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!mask.empty() && mask[i] == 0) continue;
    ++count;

    const float* r = reference.values.data() + i * static_cast<std::size_t>(reference.channels);
    const float* t = test.values.data() + i * static_cast<std::size_t>(test.channels);
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = static_cast<double>(r[c]), difference = static_cast<double>(t[c]) - value;
      sum += difference * difference / (value * value + floor);
    }
  }

  if (count == 0) throw input_error("", "no pixel to compare: the mask selects none");
  return sum / (3.0 * static_cast<double>(count));
}

}  // namespace dermis::image
