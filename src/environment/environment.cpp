// SPDX-License-Identifier: MIT
#include "environment/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "base/core/log.h"

namespace dermis::environment {

Environment checked(Environment e, const std::string& where) {
  std::size_t negative = 0;
  for (float& value : e.radiance.values)
    if (value < 0) {
      value = 0;
      ++negative;
    }
  if (negative > 0) warn("{}: {} negative values of radiance are taken as 0", where, negative);
  if (e.radiance.width != 2 * e.radiance.height)
    warn("{}: {} x {} pixels is not twice as wide as high; it is stretched over all directions as if it were",
         where, e.radiance.width, e.radiance.height);
  return e;
}

void check_size(const std::string& name, int width, int height, std::size_t values) {
  if (width < 1 || height < 1 || std::uint64_t(width) * std::uint64_t(height) > most_pixels)
    throw input_error(name, "must have 1 to {} pixels, got {} x {}", most_pixels, width, height);
  const std::size_t expected = 3 * std::size_t(width) * std::size_t(height);
  if (values != expected)
    throw input_error(name, "{} x {} pixels have {} values, got {}", width, height, expected, values);
}

Environment from_pixels(const std::string& name, int width, int height, const std::vector<float>& rgb) {
  check_size(name, width, height, rgb.size());
  if (!std::all_of(rgb.begin(), rgb.end(), [](float value) { return std::isfinite(value); }))
    throw input_error(name, "has a value that is not finite");
  return checked({.name = name, .radiance = {.width = width, .height = height, .channels = 3, .values = rgb}},
                 name);
}

glm::dvec3 direction_of(double u, double v) {
  const double azimuth = (u - 0.5) * 2 * std::numbers::pi, polar = v * std::numbers::pi;
  return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

glm::dvec2 place_of(const glm::dvec3& d) {
  return {0.5 + std::atan2(d.x, -d.z) / (2 * std::numbers::pi),
          std::acos(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi};
}

glm::dvec3 radiance_at(const image::ImageF& picture, const glm::dvec2& at) {
  const double x = at.x * picture.width - 0.5,
               y = std::clamp(at.y * picture.height - 0.5, 0.0, picture.height - 1.0);
  const double left = std::floor(x);
  const int y0 = static_cast<int>(y), y1 = std::min(y0 + 1, picture.height - 1);
  const double fx = x - left, fy = y - y0;

  int x0 = static_cast<int>(left) % picture.width;
  if (x0 < 0) x0 += picture.width;
  const int x1 = x0 + 1 < picture.width ? x0 + 1 : 0;
  const auto pixel = [&](int px, int py) {
    const float* p = picture.at(px, py);
    return glm::dvec3(p[0], p[1], p[2]);
  };
  return glm::mix(glm::mix(pixel(x0, y0), pixel(x1, y0), fx), glm::mix(pixel(x0, y1), pixel(x1, y1), fx), fy);
}

}  // namespace dermis::environment
