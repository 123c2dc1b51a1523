// SPDX-License-Identifier: MIT
#include "head/scene/similarity.h"

#include <algorithm>
#include <cmath>

namespace dermis::scene {
namespace {

constexpr double most_skew = 1e-4;  // of a rigid transform, relative

// To five digits.
double rounded(double scale) {
  const double step = std::pow(10.0, std::floor(std::log10(scale)) - 5);
  const double steps = std::round(scale / step);
  // Division by a whole number keeps 1 and its likes exact.
  return step < 1 ? steps / std::round(1 / step) : steps * step;
}

// An identity stays what it is, to the bit.
glm::dmat3 orthonormal(const glm::dmat3& m) {
  const glm::dvec3 x = glm::normalize(m[0]), y = glm::normalize(m[1] - x * glm::dot(x, m[1]));
  return {x, y, glm::cross(x, y)};
}

}  // namespace

glm::vec3 Similarity::position_in_asset(const glm::vec3& p_m) const {
  return glm::transpose(rotation) * (p_m - origin_m) / scale;
}

BoundingSphere Similarity::sphere(const BoundingSphere& s) const {
  return {position(s.centre_m), s.radius_m * scale};
}

glm::mat4x3 Similarity::matrix() const {
  const glm::mat3 scaled = rotation * scale;
  return {scaled[0], scaled[1], scaled[2], origin_m};
}

std::optional<Similarity> similarity_of(const std::array<double, 16>& m) {
  const auto column = [&](std::size_t c) { return glm::dvec3(m[4 * c], m[4 * c + 1], m[4 * c + 2]); };
  if (!std::all_of(m.begin(), m.end(), [](double x) { return std::isfinite(x); })) return {};
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) return {};

  // The largest entry first, so that squares neither overflow nor vanish.
  const glm::dmat3 axes(column(0), column(1), column(2));
  double largest = 0;
  for (glm::length_t c = 0; c < 3; ++c)
    for (glm::length_t r = 0; r < 3; ++r) largest = std::max(largest, std::abs(axes[c][r]));
  if (!(largest > 0)) return {};

  const double determinant = glm::determinant(axes / largest);
  if (!(determinant > 0)) return {};  // flat or mirrored
  const double scale = rounded(std::cbrt(determinant) * largest);
  const glm::dmat3 rotation = axes / scale;
  const glm::dmat3 squared = glm::transpose(rotation) * rotation;
  for (glm::length_t c = 0; c < 3; ++c)
    for (glm::length_t r = 0; r < 3; ++r)
      if (!(std::abs(squared[c][r] - (c == r ? 1 : 0)) <= most_skew)) return {};

  if (scale < 1e-3 || scale > 1e3 || !(glm::length(column(3)) <= 1e9)) return {};
  return Similarity{.rotation = glm::mat3(orthonormal(rotation)),
                    .scale = static_cast<float>(scale),
                    .origin_m = glm::vec3(column(3))};
}

}  // namespace dermis::scene
