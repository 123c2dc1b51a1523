// SPDX-License-Identifier: MIT
#include "viewer/model/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/compare_flip.h"
#include "image/metrics.h"

namespace dermis::viewer {
namespace {

constexpr int difference_gain = 4;

image::Image8 shown(const Picture& picture) {
  return {.width = picture.width, .height = picture.height, .rgba = picture.display_rgba};
}

image::ImageF linear(const Picture& picture) {
  return {.width = picture.width, .height = picture.height, .channels = 4, .values = picture.linear_rgba};
}

std::vector<std::uint8_t> difference(const Picture& a, const Picture& b) {
  std::vector<std::uint8_t> map(a.display_rgba.size(), 255);
  for (std::size_t i = 0; i < map.size(); ++i)
    if (i % 4 != 3) {
      const int gap = std::abs(int(a.display_rgba[i]) - int(b.display_rgba[i]));
      map[i] = static_cast<std::uint8_t>(std::min(difference_gain * gap, 255));
    }
  return map;
}

// The colours of heated metal: black, red, yellow, white.
std::vector<std::uint8_t> heat(const image::ImageF& map) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(map.values.size() * 4);
  for (const float value : map.values)
    for (const float start : {0.0f, 1.0f / 3, 2.0f / 3, -1.0f})
      rgba.push_back(start < 0 ? std::uint8_t{255}
                               : static_cast<std::uint8_t>(std::lround(
                                     255 * std::clamp((std::sqrt(value) - start) * 3, 0.0f, 1.0f))));
  return rgba;
}

}  // namespace

Comparison compare(const Picture& a, const Picture& b, const std::vector<PictureRegion>& regions,
                   CompareMode mode) {
  const image::Image8 shown_a = shown(a), shown_b = shown(b);
  const image::ImageF linear_a = linear(a), linear_b = linear(b);
  const image::ImageF flip = image::flip_map(shown_b, shown_a);

  Comparison comparison{.width = a.width, .height = a.height};
  const auto add = [&](const std::string& name, std::span<const std::uint8_t> mask, std::size_t pixels) {
    comparison.regions.push_back({.name = name,
                                  .flip = image::summarise_flip(flip, mask).mean,
                                  .psnr_db = image::psnr_db(shown_b, shown_a, mask),
                                  .rel_mse = image::rel_mse(linear_b, linear_a, mask),
                                  .pixels = pixels});
  };
  add("all of it", {}, flip.values.size());
  for (const PictureRegion& region : regions)
    if (region.pixels > 0) add(region.name, region.mask, region.pixels);

  if (mode == CompareMode::difference) comparison.map_rgba = difference(a, b);
  if (mode == CompareMode::flip) comparison.map_rgba = heat(flip);
  return comparison;
}

}  // namespace dermis::viewer
