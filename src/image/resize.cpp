// SPDX-License-Identifier: MIT
#include "image/resize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/assert.h"
#include "core/parallel.h"
#include "image/colour.h"

namespace dermis::image {

namespace {

using Rgba = std::array<float, 4>;

// A texel that alpha hides keeps this much of its weight: too little to bleed, enough that where nothing is
// visible (or alpha means nothing, as in an opaque material) the level still has the average colour.
constexpr float hidden_weight = 1.0f / 1024;

float colour_weight(float alpha) { return hidden_weight + (1 - hidden_weight) * alpha; }

/// A level before it is rounded: linear colours times colour_weight(alpha) (srgb), or plain values. The
/// weight is linear in alpha, so the average of the weights is the weight of the average.
struct Level {
  int width = 0;
  int height = 0;
  std::vector<Rgba> pixels;

  const Rgba& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Which source pixels one target pixel covers on one axis, with weights that sum to 1. An odd side has
/// three: halving 5 to 2 means 2.5 each.
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
      Rgba sum{};
      for (int j = 0; j < rows.count; ++j) {
        for (int i = 0; i < columns.count; ++i) {
          const float weight =
              rows.weight[static_cast<std::size_t>(j)] * columns.weight[static_cast<std::size_t>(i)];
          const Rgba& pixel = fetch(columns.first + i, rows.first + j);
          for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * pixel[c];
        }
      }
      half.pixels[row * row_size + x] = sum;
    }
  });
  return half;
}

std::uint8_t round8(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

Image8 round_level(const Level& level, bool srgb) {
  Image8 picture{.width = level.width, .height = level.height, .rgba = {}};
  picture.rgba.resize(level.pixels.size() * 4);
  parallel_for(static_cast<std::size_t>(level.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < level.width; ++x) {
      const Rgba& pixel = level.at(x, y);
      std::uint8_t* out = picture.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) {
        out[c] = srgb ? linear_to_srgb8(pixel[c] / colour_weight(pixel[3])) : round8(pixel[c]);
      }
      out[3] = round8(pixel[3]);
    }
  });
  return picture;
}

}  // namespace

std::vector<Image8> mip_chain(Image8 base, bool srgb) {
  DERMIS_ASSERT_LE(1, base.width);
  DERMIS_ASSERT_LE(1, base.height);
  const auto fetch_base = [&](int x, int y) {
    const std::uint8_t* p = base.at(x, y);
    const float alpha = static_cast<float>(p[3]) / 255.0f;
    Rgba pixel{};
    for (std::size_t c = 0; c < 3; ++c)
      pixel[c] = srgb ? srgb8_to_linear(p[c]) * colour_weight(alpha) : static_cast<float>(p[c]) / 255.0f;
    pixel[3] = alpha;
    return pixel;
  };
  std::vector<Image8> chain;
  Level level;
  for (int width = base.width, height = base.height; width > 1 || height > 1;
       width = level.width, height = level.height) {
    if (chain.empty()) {
      level = halve(width, height, fetch_base);
    } else {
      level = halve(width, height, [&level](int x, int y) -> const Rgba& { return level.at(x, y); });
    }
    chain.push_back(round_level(level, srgb));
  }
  chain.insert(chain.begin(), std::move(base));
  return chain;
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
