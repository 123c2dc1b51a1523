// SPDX-License-Identifier: MIT
#include "image/metrics.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "base/core/error.h"

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

constexpr double rel_mse_floor = 0.01;

/// Returns the mean of one channel over the up to eight neighbours of a pixel within the mask, or its own
/// value if there is none.
double mean_around(const ImageF& picture, int x, int y, std::size_t channel,
                   std::span<const std::uint8_t> mask) {
  const auto at = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(i);
  };
  const auto value = [&](std::size_t pixel) {
    return double{picture.values[pixel * static_cast<std::size_t>(picture.channels) + channel]};
  };

  double sum = 0;
  int count = 0;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, picture.height - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, picture.width - 1); ++i) {
      if ((i == x && j == y) || mask[at(i, j)] == 0) continue;
      sum += value(at(i, j));
      ++count;
    }
  return count > 0 ? sum / count : value(at(x, y));
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
      sum += difference * difference / (value * value + rel_mse_floor);
    }
  }

  if (count == 0) throw input_error("", "no pixel to compare: the mask selects none");
  return sum / (3.0 * static_cast<double>(count));
}

double rel_mse_less_noise(const ImageF& reference, const ImageF& variance, const ImageF& test,
                          std::span<const std::uint8_t> mask, std::span<const std::uint8_t> around) {
  check_sizes(reference, test, mask);
  check_sizes(reference, variance, around);
  DERMIS_ASSERT_LE(3, std::min({reference.channels, variance.channels, test.channels}));

  double sum = 0;
  std::size_t count = 0, pixel = 0;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x, ++pixel) {
      if (mask[pixel] == 0) continue;
      ++count;

      for (std::size_t c = 0; c < 3; ++c) {
        const auto value = [&](const ImageF& picture) {
          return double{picture.values[pixel * static_cast<std::size_t>(picture.channels) + c]};
        };
        // E (t - r - noise)^2 = (t - r)^2 + variance
        const double difference = value(test) - value(reference);
        const double around_it = mean_around(reference, x, y, c, around);
        sum += (difference * difference - value(variance)) / (around_it * around_it + rel_mse_floor);
      }
    }

  if (count == 0) throw input_error("", "no pixel to compare: the mask selects none");
  return sum / (3.0 * static_cast<double>(count));
}

}  // namespace dermis::image
