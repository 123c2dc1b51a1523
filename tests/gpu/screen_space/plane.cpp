// SPDX-License-Identifier: MIT
#include "plane.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "api/asset_state.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "tissue/gaussians/known.h"

namespace dermis::tests {
namespace {

using std::numbers::pi;
constexpr double distance_mm = 500;

// The integral of the share of a Gaussian below x.
double integrated(double x, double sigma) {
  const double below = std::erfc(-x / (sigma * std::numbers::sqrt2)) / 2;
  return x * below + sigma / std::sqrt(2 * pi) * std::exp(-x * x / (2 * sigma * sigma));
}

glm::dvec3 direction_of(double tilt_deg, double azimuth_deg) {
  const double tilt = tilt_deg * pi / 180, azimuth = azimuth_deg * pi / 180;
  return {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
}

// White skin at x < 0, or black skin at x > 0.
scene::AssetData half(bool white) {
  scene::AssetData made = scene::plane(0.3, glm::dmat2(1), {}, 2);
  made.materials.front().base_colour = glm::vec4(glm::vec3(white ? 1 : 0), 1);
  scene::Primitive& part = made.primitives.front();
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < part.indices.size(); i += 3) {
    float middle_m = 0;
    for (std::size_t k = 0; k < 3; ++k) middle_m += part.vertices[part.indices[i + k]].position_m.x;
    if ((middle_m < 0) == white)
      kept.insert(kept.end(), part.indices.begin() + static_cast<std::ptrdiff_t>(i),
                  part.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  part.indices = std::move(kept);
  return made;
}

Scene half_white_plane() {
  scene::AssetData made = half(true);
  const scene::AssetData other = half(false);
  made.materials.push_back(other.materials.front());
  made.primitives.push_back(other.primitives.front());
  made.primitives.back().material = 1;
  return wrap(std::move(made));
}

}  // namespace

const Scene& lit_edge() {
  static const Scene plane = half_white_plane();
  return plane;
}

Asset half_plane(bool white) { return Asset::State::make(scene::measured(half(white))); }

RenderSettings facing_plane(const std::string& technique, double pixels_per_mm, double tilt_deg,
                            double azimuth_deg) {
  RenderSettings s = small_settings(technique);
  s.output.width = plane_width;
  s.output.height = plane_height;
  s.output.bloom = 0;
  s.quality.samples = 1;
  s.skin.mix = 1;
  s.lighting.ambient = 1;
  s.lighting.rig_lights = 0;
  s.lighting.specular = false;
  const glm::dvec3 eye_m = direction_of(tilt_deg, azimuth_deg) * distance_mm / 1000.0;
  s.camera.eye_m = {eye_m.x, eye_m.y, eye_m.z};
  s.camera.target_m = {0, 0, 0};
  s.camera.fov_deg = 2 * std::atan(plane_height / (2 * distance_mm * pixels_per_mm)) * 180 / pi;
  return s;
}

glm::dvec2 seen_mm(const RenderSettings& s, int x, int y) {
  const std::array<double, 3>& eye = s.camera.eye_m.value();
  const glm::dvec3 from = glm::dvec3(eye[0], eye[1], eye[2]) * 1000.0, forward = -glm::normalize(from),
                   right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))),
                   up = glm::cross(right, forward);
  const double tangent = std::tan(s.camera.fov_deg.value() * pi / 360),
               across = (2 * (x + 0.5) / plane_width - 1) * tangent * plane_width / plane_height,
               down = (2 * (y + 0.5) / plane_height - 1) * tangent;
  const glm::dvec3 ray = forward + across * right - down * up, hit = from - ray * (from.z / ray.z);
  return {hit.x, hit.y};
}

std::array<double, 3> exact_edge(double x_mm, double width_mm) {
  std::array<double, 3> light{};
  for (const Gaussian& term : gaussians::skin_six().terms) {
    const double sigma = std::sqrt(term.variance_mm2);
    const double share =
        width_mm > 0
            ? (integrated(-x_mm + width_mm / 2, sigma) - integrated(-x_mm - width_mm / 2, sigma)) / width_mm
            : std::erfc(x_mm / (sigma * std::numbers::sqrt2)) / 2;
    for (std::size_t c = 0; c < 3; ++c) light[c] += term.weight[c] * share;
  }
  return light;
}

std::array<double, 3> pixel(const Picture& picture, int x, int y) {
  const float* at = &picture.linear_rgba[4 * static_cast<std::size_t>(y * picture.width + x)];
  return {at[0], at[1], at[2]};
}

std::array<double, 3> distance_from_exact(const Picture& picture, const RenderSettings& s, double width_mm) {
  std::array<double, 3> largest{};
  for (int x = 0; x < plane_width; ++x) {
    const std::array<double, 3> found = pixel(picture, x, middle_row),
                                wanted = exact_edge(seen_mm(s, x, middle_row).x, width_mm);
    for (std::size_t c = 0; c < 3; ++c) largest[c] = std::max(largest[c], std::abs(found[c] - wanted[c]));
  }
  return largest;
}

double spread_of_red(const Picture& picture, const RenderSettings& s) {
  double integral = 0;
  for (int x = 1; x < plane_width; ++x) {
    const double from = seen_mm(s, x - 1, middle_row).x, to = seen_mm(s, x, middle_row).x;
    if (to < 0 || to > 14) continue;
    const double before = from < 0 ? 0 : from * pixel(picture, x - 1, middle_row)[0];
    integral += (to - std::max(from, 0.0)) / 2 * (before + to * pixel(picture, x, middle_row)[0]);
  }
  double variance_mm2 = 0;
  for (const Gaussian& term : gaussians::skin_six().terms) variance_mm2 += term.weight[0] * term.variance_mm2;
  return std::sqrt(4 * integral / variance_mm2);
}

}  // namespace dermis::tests
