// SPDX-License-Identifier: MIT
#include "image/compare.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "image/codec.h"
#include "image/colour.h"
#include "image/metrics.h"

namespace dermis::image {
namespace {

std::uint64_t counted(const Region& region, std::size_t pixels) {
  if (region.empty()) return pixels;
  return static_cast<std::uint64_t>(
      std::count_if(region.begin(), region.end(), [](std::uint8_t inside) { return inside != 0; }));
}

ImageF to_linear(const Image8& picture) {
  ImageF linear{.width = picture.width, .height = picture.height, .channels = 3, .values = {}};
  linear.values.resize(picture.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i)
    for (std::size_t c = 0; c < 3; ++c) linear.values[i * 3 + c] = srgb8_to_linear(picture.rgba[i * 4 + c]);
  return linear;
}

}  // namespace

Region load_region(const std::filesystem::path& path, int width, int height) {
  const Image8 picture = load_image8(path);
  if (picture.width != width || picture.height != height)
    throw input_error(path.string(), "the region is {} x {} pixels, the pictures are {} x {}", picture.width,
                      picture.height, width, height);
  Region region(picture.rgba.size() / 4);
  for (std::size_t i = 0; i < region.size(); ++i) {
    const std::uint8_t* p = picture.rgba.data() + i * 4;
    region[i] = std::max({p[0], p[1], p[2]}) > 0 ? 1 : 0;
  }
  if (counted(region, 0) == 0)
    throw input_error(path.string(),
                      "the region is black everywhere; pixels that are not black are compared");
  return region;
}

ZTest z_test(const ImageF& reference, const ImageF& test, std::span<const ImageF> variances,
             const Region& region) {
  DERMIS_ASSERT(!variances.empty());
  const auto same_size = [&](const ImageF& other) {
    return other.width == reference.width && other.height == reference.height;
  };
  if (!same_size(test) || !std::all_of(variances.begin(), variances.end(), same_size))
    throw input_error("", "pictures and variances of different sizes cannot be compared");

  const auto value = [](const ImageF& picture, std::size_t pixel, std::size_t channel) {
    return static_cast<double>(picture.values[pixel * static_cast<std::size_t>(picture.channels) + channel]);
  };

  const std::size_t pixels =
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  if (!region.empty() && region.size() != pixels)
    throw input_error("", "the mask has {} pixels, the pictures have {}", region.size(), pixels);

  std::uint64_t beyond_2 = 0, beyond_3 = 0, values = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!region.empty() && region[i] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      double variance = 0;
      for (const ImageF& one : variances) {
        if (value(one, i, c) < 0)
          throw input_error("", "variance is negative at pixel {}, {}: {}",
                            i % static_cast<std::size_t>(reference.width),
                            i / static_cast<std::size_t>(reference.width), value(one, i, c));
        variance += value(one, i, c);
      }
      const double difference = value(test, i, c) - value(reference, i, c);
      ++values;
      beyond_2 += difference * difference > 4 * variance;
      beyond_3 += difference * difference > 9 * variance;
    }
  }

  if (values == 0) throw input_error("", "no pixel to compare: the mask selects none");
  const double count = static_cast<double>(values);
  return {.beyond_2 = static_cast<double>(beyond_2) / count,
          .beyond_3 = static_cast<double>(beyond_3) / count,
          .values = values};
}

Comparison compare(const Image8& reference, const Image8& test, const Region& region) {
  Comparison result;
  result.psnr_db = psnr_db(reference, test, region);
  result.rel_mse = rel_mse(to_linear(reference), to_linear(test), region);
  result.flip_map = flip_map(reference, test);
  result.flip = summarise_flip(result.flip_map, region);
  result.pixels = counted(region, reference.rgba.size() / 4);
  return result;
}

Comparison compare(const ImageF& reference, const ImageF& test, ToneMap tone_map,
                   std::span<const ImageF> variances, const Region& region) {
  Comparison result;
  result.psnr_db = psnr_db(to_display(reference, tone_map), to_display(test, tone_map), region);
  result.rel_mse = rel_mse(reference, test, region);
  if (!variances.empty()) result.z = z_test(reference, test, variances, region);
  HdrFlip flip = hdr_flip(reference, test);
  result.flip = summarise_flip(flip.map, region);
  result.flip_map = std::move(flip.map);
  result.start_exposure = flip.start_exposure;
  result.stop_exposure = flip.stop_exposure;
  result.exposures = flip.exposures;
  result.pixels = counted(region, result.flip_map.values.size());
  return result;
}

}  // namespace dermis::image
