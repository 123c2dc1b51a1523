// SPDX-License-Identifier: MIT
#include "image/resize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/core/assert.h"
#include "base/core/parallel.h"
#include "image/shrink.h"

namespace dermis::image {

namespace {

/// A level before rounding, see Texel.
struct Level {
  int width = 0;
  int height = 0;
  std::vector<Texel> pixels;

  const Texel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The source pixels that one target pixel covers on one axis, with weights that sum to 1. From an odd side
/// it covers three: halving 5 to 2 means 2.5 each.
struct Cover {
  int first = 0;
  int count = 0;
  std::array<float, 3> weight{};
};

Cover cover(int target, int target_size, int source_size) {
  const double scale = static_cast<double>(source_size) / target_size;
  const double begin = target * scale;
  const double end = begin + scale;
  Cover c{.first = static_cast<int>(begin), .count = 0, .weight = {}};
  for (int i = c.first; i < source_size && i < end && c.count < 3; ++i) {
    const double part = std::min<double>(end, i + 1) - std::max<double>(begin, i);
    c.weight[static_cast<std::size_t>(c.count++)] = static_cast<float>(part / scale);
  }
  return c;
}

template <class Fetch>
Level halve(int width, int height, const Fetch& fetch) {
  Level half{.width = std::max(1, width / 2), .height = std::max(1, height / 2), .pixels = {}};
  const std::size_t row_size = static_cast<std::size_t>(half.width);
  half.pixels.resize(row_size * static_cast<std::size_t>(half.height));

  std::vector<Cover> all_columns(row_size);
  for (std::size_t x = 0; x < row_size; ++x) all_columns[x] = cover(static_cast<int>(x), half.width, width);

  parallel_for(static_cast<std::size_t>(half.height), [&](std::size_t row) {
    const Cover rows = cover(static_cast<int>(row), half.height, height);
    for (std::size_t x = 0; x < row_size; ++x) {
      const Cover& columns = all_columns[x];
      Texel sum{};
      for (int j = 0; j < rows.count; ++j) {
        for (int i = 0; i < columns.count; ++i) {
          const float weight =
              rows.weight[static_cast<std::size_t>(j)] * columns.weight[static_cast<std::size_t>(i)];
          const Texel& pixel = fetch(columns.first + i, rows.first + j);
          for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * pixel[c];
        }
      }
      half.pixels[row * row_size + x] = sum;
    }
  });

  return half;
}

Image8 round_level(const Level& level, bool srgb) {
  Image8 picture{.width = level.width, .height = level.height, .rgba = {}};
  picture.rgba.resize(level.pixels.size() * 4);
  parallel_for(static_cast<std::size_t>(level.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < level.width; ++x) round_texel(level.at(x, y).data(), srgb, picture.at(x, y));
  });
  return picture;
}

}  // namespace

void for_each_mip(const Image8& base, bool srgb, const std::function<void(const Image8& mip)>& body) {
  DERMIS_ASSERT_LE(1, base.width);
  DERMIS_ASSERT_LE(1, base.height);
  body(base);
  const auto fetch_base = [&](int x, int y) { return weighted(base.at(x, y), srgb); };
  Level level;
  for (int width = base.width, height = base.height; width > 1 || height > 1;
       width = level.width, height = level.height) {
    if (level.pixels.empty()) {
      level = halve(width, height, fetch_base);
    } else {
      level = halve(width, height, [&level](int x, int y) -> const Texel& { return level.at(x, y); });
    }
    body(round_level(level, srgb));
  }
}

ImageF downsample_box(const ImageF& picture, int factor) {
  DERMIS_ASSERT_LE(1, factor);
  DERMIS_ASSERT_EQ(picture.width % factor, 0);
  DERMIS_ASSERT_EQ(picture.height % factor, 0);
  DERMIS_ASSERT_LE(picture.channels, 4);

  ImageF small{.width = picture.width / factor,
               .height = picture.height / factor,
               .channels = picture.channels,
               .values = {}};
  small.values.resize(picture.values.size() / static_cast<std::size_t>(factor) /
                      static_cast<std::size_t>(factor));

  const double scale = 1.0 / (static_cast<double>(factor) * factor);
  parallel_for(static_cast<std::size_t>(small.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < small.width; ++x) {
      std::array<double, 4> sum{};
      for (int j = 0; j < factor; ++j) {
        for (int i = 0; i < factor; ++i) {
          const float* in = picture.at(x * factor + i, y * factor + j);
          for (int c = 0; c < small.channels; ++c)
            sum[static_cast<std::size_t>(c)] += static_cast<double>(in[c]);
        }
      }

      float* out = small.at(x, y);
      for (int c = 0; c < small.channels; ++c)
        out[c] = static_cast<float>(sum[static_cast<std::size_t>(c)] * scale);
    }
  });
  return small;
}

}  // namespace dermis::image
