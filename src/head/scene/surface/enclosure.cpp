// SPDX-License-Identifier: MIT
// Based on: [KHM98] Klosowski, Held, Mitchell, Sowizral, Zikan: Efficient Collision Detection Using Bounding
// Volume Hierarchies of k-DOPs. IEEE TVCG 4(1), 1998 (slabs of fixed directions).
#include "head/scene/surface/enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "head/scene/placement.h"

namespace dermis::scene {
namespace {

constexpr std::size_t axes = 25;

// Between two planes across each axis lies everything.
struct Slabs {
  std::array<glm::dvec3, axes> axis;
  std::array<double, axes> low_m, high_m;
  bool any = false;
};

// Returns the axes of a cube through its faces, edges and corners, and those from its middle by one step
// along an edge and two along another. No direction is farther than 23 degrees from one of them.
std::array<glm::dvec3, axes> directions() {
  std::array<glm::dvec3, axes> found;
  std::size_t count = 0;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z) {
        std::array<int, 3> steps = {std::abs(x), std::abs(y), std::abs(z)};
        std::sort(steps.begin(), steps.end());
        const bool of_cube = steps[2] == 1;
        const bool between = steps == std::array<int, 3>{0, 1, 2};
        // Of two opposite directions the one that comes later.
        const bool later = x > 0 || (x == 0 && (y > 0 || (y == 0 && z > 0)));
        if (later && (of_cube || between)) found[count++] = glm::normalize(glm::dvec3(x, y, z));
      }
  return found;
}

template <class ForEach>
Slabs slabs_around(const ForEach& for_each) {
  Slabs s{.axis = directions(), .low_m = {}, .high_m = {}};
  for_each([&](const glm::vec3& p) {
    for (std::size_t i = 0; i < axes; ++i) {
      const double along_m = glm::dot(s.axis[i], glm::dvec3(p));
      s.low_m[i] = s.any ? std::min(s.low_m[i], along_m) : along_m;
      s.high_m[i] = s.any ? std::max(s.high_m[i], along_m) : along_m;
    }
    s.any = true;
  });
  return s;
}

// One face of the body.
struct Face {
  glm::dvec3 outwards;
  double at_m = 0;
};

// Returns every point where three faces meet and that no other face cuts off.
std::vector<glm::vec3> corners_of(const std::vector<Face>& faces, double tolerance_m) {
  std::vector<glm::vec3> corners;
  const auto add = [&](const Face& a, const Face& b, const Face& c) {
    const glm::dvec3 bc = glm::cross(b.outwards, c.outwards);
    const double volume = glm::dot(a.outwards, bc);
    if (std::abs(volume) < 1e-3) return;

    const glm::dvec3 p = (a.at_m * bc + b.at_m * glm::cross(c.outwards, a.outwards) +
                          c.at_m * glm::cross(a.outwards, b.outwards)) /
                         volume;
    const bool cut_off = std::any_of(faces.begin(), faces.end(), [&](const Face& face) {
      return glm::dot(face.outwards, p) > face.at_m + tolerance_m;
    });
    const auto is_here = [&](const glm::vec3& q) {
      return glm::distance(glm::dvec3(q), p) < 4 * tolerance_m;
    };
    if (!cut_off && std::none_of(corners.begin(), corners.end(), is_here)) corners.emplace_back(p);
  };

  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j)
      for (std::size_t k = j + 1; k < faces.size(); ++k) add(faces[i], faces[j], faces[k]);
  return corners;
}

template <class ForEach>
std::vector<glm::vec3> corners_around(const ForEach& for_each) {
  const Slabs s = slabs_around(for_each);
  if (!s.any) return {};

  double size_m = 0;
  for (std::size_t i = 0; i < axes; ++i) size_m = std::max(size_m, s.high_m[i] - s.low_m[i]);
  const double margin_m = 1e-5 * size_m;

  std::vector<Face> faces;
  for (std::size_t i = 0; i < axes; ++i) {
    faces.push_back({s.axis[i], s.high_m[i] + margin_m});
    faces.push_back({-s.axis[i], margin_m - s.low_m[i]});
  }
  return corners_of(faces, 0.1 * margin_m);
}

}  // namespace

std::vector<glm::vec3> enclosing_corners(std::span<const glm::vec3> points_m) {
  return corners_around([&](const auto& visit) { std::for_each(points_m.begin(), points_m.end(), visit); });
}

std::vector<glm::vec3> enclosing_corners(const AssetData& scene) {
  return corners_around([&](const auto& visit) {
    for (const Primitive& p : scene.primitives) for_each_position(p, visit);
  });
}

}  // namespace dermis::scene
