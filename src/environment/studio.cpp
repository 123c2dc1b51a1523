// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "environment/environment.h"

namespace dermis::environment {
namespace {

// A rectangular soft light: centre, half its size, radiance. Degrees; azimuth from +Z towards +X.
struct SoftBox {
  double azimuth_deg, elevation_deg, half_width_deg, half_height_deg;
  glm::dvec3 radiance;
};

constexpr double edge_deg = 3;  // soft, as cloth is, so that harmonics do not ring

double inside(double distance_deg, double half_deg) {
  const double t = std::clamp((half_deg + edge_deg - distance_deg) / (2 * edge_deg), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

Environment studio() {
  const SoftBox boxes[] = {{50, 35, 24, 18, {7.0, 6.7, 6.3}},
                           {-60, 10, 16, 28, {1.5, 1.6, 1.75}},
                           {165, 30, 10, 34, {4.5, 4.5, 4.5}}};
  Environment e{.name = "studio", .radiance = {.width = 512, .height = 256, .channels = 3, .values = {}}};

  for (int y = 0; y < e.radiance.height; ++y)
    for (int x = 0; x < e.radiance.width; ++x) {
      const glm::dvec3 d = direction_of((x + 0.5) / e.radiance.width, (y + 0.5) / e.radiance.height);
      const double elevation_deg = std::asin(d.y) * 180 / std::numbers::pi,
                   azimuth_deg = std::atan2(d.x, d.z) * 180 / std::numbers::pi;

      // A grey room, lighter above; the floor has a trace of wood.
      glm::dvec3 radiance = d.y > 0 ? glm::dvec3(0.05 + 0.07 * d.y) : glm::dvec3(0.05, 0.045, 0.04);
      for (const SoftBox& box : boxes) {
        const double around_deg = std::abs(std::remainder(azimuth_deg - box.azimuth_deg, 360.0)) *
                                  std::cos(elevation_deg * std::numbers::pi / 180);
        radiance += box.radiance * inside(around_deg, box.half_width_deg) *
                    inside(std::abs(elevation_deg - box.elevation_deg), box.half_height_deg);
      }

      for (int c = 0; c < 3; ++c) e.radiance.values.push_back(static_cast<float>(radiance[c]));
    }
  return e;
}

}  // namespace dermis::environment
