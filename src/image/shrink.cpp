// SPDX-License-Identifier: MIT
#include "image/shrink.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "image/colour.h"

namespace dermis::image {

namespace {

// An invisible texel keeps this much of its weight, which is too little to bleed. It is enough that the
// average has the mean colour where nothing is visible, or alpha means nothing, as in an opaque material.
constexpr float hidden_weight = 1.0f / 1024;

float colour_weight(float alpha) { return hidden_weight + (1 - hidden_weight) * alpha; }

std::uint8_t round8(float value) {
  const float steps = std::clamp(value, 0.0f, 1.0f) * 255.0f;
  return static_cast<std::uint8_t>(double{steps} + 0.5);  // as std::lround(), without a call
}

std::uint16_t round16(float value) {
  return static_cast<std::uint16_t>(std::clamp(value, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

std::uint8_t nearest8(std::uint16_t value) {
  return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
}

/// Returns the sRGB curve for 16-bit values, made at the first call.
const std::vector<float>& linear_of_16_bits() {
  static const std::vector<float> table = [] {
    std::vector<float> made(65536);
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = srgb_to_linear(static_cast<float>(i) / 65535.0f);
    return made;
  }();
  return table;
}

Texel weighted16(const std::uint16_t* rgba, bool srgb) {
  const float alpha = static_cast<float>(rgba[3]) / 65535.0f;
  Texel texel{0, 0, 0, alpha};
  for (std::size_t c = 0; c < 3; ++c)
    texel[c] =
        srgb ? linear_of_16_bits()[rgba[c]] * colour_weight(alpha) : static_cast<float>(rgba[c]) / 65535.0f;
  return texel;
}

}  // namespace

int halved(int side, int halvings) { return std::max(1, side >> std::min(halvings, 30)); }

Texel weighted(const std::uint8_t* rgba, bool srgb) {
  const float alpha = static_cast<float>(rgba[3]) / 255.0f;
  Texel texel{0, 0, 0, alpha};
  for (std::size_t c = 0; c < 3; ++c)
    texel[c] = srgb ? srgb8_to_linear(rgba[c]) * colour_weight(alpha) : static_cast<float>(rgba[c]) / 255.0f;
  return texel;
}

void round_texel(const float* average, bool srgb, std::uint8_t* rgba) {
  for (std::size_t c = 0; c < 3; ++c)
    rgba[c] = srgb ? linear_to_srgb8(average[c] / colour_weight(average[3])) : round8(average[c]);
  rgba[3] = round8(average[3]);
}

AreaAverage::AreaAverage(Size source, Size target, int channels, Row finished)
    : target_(target),
      channels_(static_cast<std::size_t>(channels)),
      finished_(std::move(finished)),
      columns_(covers(source.width, target.width)),
      rows_(covers(source.height, target.height)),
      sums_(static_cast<std::size_t>(target.height)),
      line_(static_cast<std::size_t>(target.width) * channels_) {}

std::vector<AreaAverage::Cover> AreaAverage::covers(int source, int target) {
  DERMIS_ASSERT_LE(1, target);
  DERMIS_ASSERT_LE(target, source);
  std::vector<Cover> all(static_cast<std::size_t>(source));
  for (int i = 0; i < source; ++i) {
    // In units of 1 / target of a source pixel all limits are whole numbers: source pixel i is [i, i + 1)
    // target, target pixel t is [t, t + 1) source.
    const std::int64_t begin = std::int64_t{i} * target, end = begin + target;
    Cover& c = all[static_cast<std::size_t>(i)];
    c.first = static_cast<int>(begin / source);
    const std::int64_t limit = (std::int64_t{c.first} + 1) * source;
    c.share[0] = static_cast<float>(std::min(end, limit) - begin) / static_cast<float>(source);
    c.share[1] = static_cast<float>(std::max<std::int64_t>(end - limit, 0)) / static_cast<float>(source);
  }
  return all;
}

void AreaAverage::add(int y, std::span<const float> values, int first, int step) {
  std::ranges::fill(line_, 0.0f);
  const std::size_t count = values.size() / channels_;
  for (std::size_t i = 0; i < count; ++i) {
    const Cover& c = columns_[static_cast<std::size_t>(first) + i * static_cast<std::size_t>(step)];
    float* to = &line_[static_cast<std::size_t>(c.first) * channels_];
    const float* from = &values[i * channels_];
    for (std::size_t k = 0; k < channels_; ++k) to[k] += c.share[0] * from[k];
    if (c.share[1] > 0)
      for (std::size_t k = 0; k < channels_; ++k) to[channels_ + k] += c.share[1] * from[k];
  }

  const Cover& rows = rows_[static_cast<std::size_t>(y)];
  for (std::size_t j = 0; j < 2; ++j) {
    if (rows.share[j] <= 0) continue;
    std::vector<float>& sum = sums_[static_cast<std::size_t>(rows.first) + j];
    sum.resize(line_.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += rows.share[j] * line_[i];
  }
}

void AreaAverage::done_to(int y) {
  const auto after = static_cast<std::size_t>(y) + 1;
  const int end = after < rows_.size() ? rows_[after].first : target_.height;
  for (; next_ < end; ++next_) {
    std::vector<float>& sum = sums_[static_cast<std::size_t>(next_)];
    sum.resize(line_.size());
    finished_(next_, sum);
    sum = {};
  }
}

Shrinking::Shrinking(int width, int height, const Shrink& shrink)
    : shrink_(shrink),
      picture_{
          .width = halved(width, shrink.halvings), .height = halved(height, shrink.halvings), .rgba = {}},
      average_({width, height}, {picture_.width, picture_.height}, 4,
               [this](int y, std::span<const float> values) {
                 for (int x = 0; x < picture_.width; ++x)
                   round_texel(&values[static_cast<std::size_t>(x) * 4], shrink_.srgb, picture_.at(x, y));
                 if (!picture_.rgba16.empty())
                   std::ranges::transform(
                       values, &picture_.rgba16[values.size() * static_cast<std::size_t>(y)], round16);
               }) {
  picture_.rgba.resize(static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height) *
                       4);
}

void Shrinking::row8(int y, const std::uint8_t* rgba, int count, int first, int step) {
  if (shrink_.halvings == 0) {
    for (int i = 0; i < count; ++i) std::copy_n(rgba + 4 * i, 4, picture_.at(first + i * step, y));
    return;
  }
  values_.resize(static_cast<std::size_t>(count) * 4);
  for (int i = 0; i < count; ++i)
    std::ranges::copy(weighted(rgba + 4 * i, shrink_.srgb), &values_[static_cast<std::size_t>(i) * 4]);
  average_.add(y, values_, first, step);
}

void Shrinking::row16(int y, const std::uint16_t* rgba, int count, int first, int step) {
  if (shrink_.deep) picture_.rgba16.resize(picture_.rgba.size());
  if (shrink_.halvings == 0) {
    for (int i = 0; i < count; ++i) {
      std::uint8_t* to = picture_.at(first + i * step, y);
      std::transform(rgba + 4 * i, rgba + 4 * i + 4, to, nearest8);
      if (shrink_.deep) std::copy_n(rgba + 4 * i, 4, picture_.rgba16.begin() + (to - picture_.rgba.data()));
    }
    return;
  }
  values_.resize(static_cast<std::size_t>(count) * 4);
  for (int i = 0; i < count; ++i)
    std::ranges::copy(weighted16(rgba + 4 * i, shrink_.srgb), &values_[static_cast<std::size_t>(i) * 4]);
  average_.add(y, values_, first, step);
}

void Shrinking::done_to(int y) {
  if (shrink_.halvings > 0) average_.done_to(y);
}

}  // namespace dermis::image
