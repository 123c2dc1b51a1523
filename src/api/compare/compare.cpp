// SPDX-License-Identifier: MIT
// Implements the comparison of two pictures of include/dermis/compare.h.
#include "dermis/compare.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/core/error.h"
#include "image/compare_flip.h"
#include "image/metrics.h"

namespace dermis {
namespace {

template <class Value>
void check_pixels(std::string_view name, const Pixels<Value>& p) {
  if (p.width < 1 || p.height < 1 || p.channels < 3 || p.channels > 4)
    throw input_error(std::string(name), "must be pixels of 3 or 4 values, at least one, got {} x {} x {}",
                      p.width, p.height, p.channels);
  const std::size_t count = static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height) *
                            static_cast<std::size_t>(p.channels);
  if (p.values.size() != count)
    throw input_error(std::string(name), "has {} values, {} x {} pixels of {} are {}", p.values.size(),
                      p.width, p.height, p.channels, count);
}

void check_finite(std::string_view name, const LinearPixels& p, bool at_least_0 = false) {
  const auto wrong = std::find_if(p.values.begin(), p.values.end(), [&](float value) {
    return !std::isfinite(value) || (at_least_0 && value < 0);
  });
  if (wrong == p.values.end()) return;
  const auto pixel = (wrong - p.values.begin()) / p.channels;
  throw input_error(std::string(name), "holds {} in the pixel {}, {}; values must be finite{}", *wrong,
                    pixel % p.width, pixel / p.width, at_least_0 ? " and at least 0" : "");
}

template <class Value>
void check_pair(const Pixels<Value>& reference, const Pixels<Value>& test, PixelMask mask) {
  check_pixels("reference", reference);
  check_pixels("test", test);
  if (reference.width != test.width || reference.height != test.height)
    throw input_error("test", "is {} x {} pixels, reference is {} x {}", test.width, test.height,
                      reference.width, reference.height);
  const auto pixels = static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height);
  if (!mask.empty() && mask.size() != pixels)
    throw input_error("mask", "has {} values, pictures have {} pixels", mask.size(), pixels);
}

image::Image8 image_of(const DisplayPixels& p) {
  image::Image8 out{.width = p.width, .height = p.height, .rgba = {}};
  if (p.channels == 4) {
    out.rgba.assign(p.values.begin(), p.values.end());
    return out;
  }
  out.rgba.reserve(p.values.size() / 3 * 4);
  for (std::size_t i = 0; i < p.values.size(); i += 3)
    out.rgba.insert(out.rgba.end(), {p.values[i], p.values[i + 1], p.values[i + 2], 255});
  return out;
}

image::ImageF image_of(const LinearPixels& p) {
  return {.width = p.width,
          .height = p.height,
          .channels = p.channels,
          .values = {p.values.begin(), p.values.end()}};
}

}  // namespace

Flip flip(const DisplayPixels& reference, const DisplayPixels& test, PixelMask mask) {
  check_pair(reference, test, mask);
  image::ImageF map = image::flip_map(image_of(reference), image_of(test));
  const double mean = image::summarise_flip(map, mask).mean;
  return {.map = std::move(map.values), .mean = mean};
}

Flip flip(const LinearPixels& reference, const LinearPixels& test, PixelMask mask) {
  check_pair(reference, test, mask);
  check_finite("reference", reference);
  check_finite("test", test);
  image::HdrFlip found = image::hdr_flip(image_of(reference), image_of(test));
  const double mean = image::summarise_flip(found.map, mask).mean;
  return {.map = std::move(found.map.values),
          .mean = mean,
          .start_exposure = found.start_exposure,
          .stop_exposure = found.stop_exposure,
          .exposures = found.exposures};
}

double psnr_db(const DisplayPixels& reference, const DisplayPixels& test, PixelMask mask) {
  check_pair(reference, test, mask);
  return image::psnr_db(image_of(reference), image_of(test), mask);
}

double relative_mse(const LinearPixels& reference, const LinearPixels& test, PixelMask mask) {
  check_pair(reference, test, mask);
  check_finite("reference", reference);
  check_finite("test", test);
  return image::rel_mse(image_of(reference), image_of(test), mask);
}

double relative_mse_less_noise(const LinearPixels& reference, const LinearPixels& variance,
                               const LinearPixels& test, PixelMask mask) {
  check_pair(reference, test, mask);
  check_pixels("variance", variance);
  if (variance.width != reference.width || variance.height != reference.height)
    throw input_error("variance", "is {} x {} pixels, reference is {} x {}", variance.width, variance.height,
                      reference.width, reference.height);
  check_finite("reference", reference);
  check_finite("test", test);
  check_finite("variance", variance, true);
  const std::vector<std::uint8_t> all(
      static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height), 1);
  const PixelMask counted = mask.empty() ? PixelMask(all) : mask;
  return image::rel_mse_less_noise(image_of(reference), image_of(variance), image_of(test), counted, counted);
}

}  // namespace dermis
