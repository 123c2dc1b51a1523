// SPDX-License-Identifier: MIT
#include "truth/regions/parts.h"

#include <algorithm>
#include <optional>

#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "truth/regions/head_frame.h"

namespace dermis::regions {
namespace {

using Points = std::vector<glm::dvec3>;

/// Returns the middles of the mesh's thin triangles beside the head; of those so large that their corners
/// would count as outside, the corners too.
Points thin_points(const rays::RayScene& rays, const HeadFrame& frame, const scene::SkinMesh& mesh) {
  const std::size_t count = mesh.indices.size() / 3;
  const auto corner = [&](std::size_t triangle, std::size_t k) {
    return glm::dvec3(mesh.vertices[mesh.indices[3 * triangle + k]].position_m);
  };

  std::vector<std::uint8_t> thin(count);
  parallel_for(count, [&](std::size_t t) {
    const glm::dvec3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    rays::SurfacePoint middle;
    middle.position_m = (a + b + c) / 3.0;
    const glm::dvec3 across = glm::cross(b - a, c - a);
    if (!frame.beside_the_head(middle.position_m) || across == glm::dvec3(0)) return;
    middle.face_normal = glm::normalize(across);
    thin[t] = thickness_m(rays, middle) < frame.ear_thickness_m();
  });

  Points points;
  for (std::size_t t = 0; t < count; ++t) {
    if (!thin[t]) continue;
    const glm::dvec3 middle = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0;
    points.push_back(middle);
    for (std::size_t k = 0; k < 3; ++k)
      if (glm::distance(corner(t, k), middle) > frame.ear_closing_m()) points.push_back(corner(t, k));
  }
  return points;
}

/// Returns the distance to the nearest of the points, which are sorted by height; `most_m` if none is nearer.
double distance_m(const Points& points, const glm::dvec3& p, double most_m) {
  const auto lower = [](const glm::dvec3& point, double y) { return point.y < y; };
  double nearest_m = most_m;
  for (auto i = std::lower_bound(points.begin(), points.end(), p.y - most_m, lower);
       i != points.end() && i->y < p.y + most_m; ++i)
    nearest_m = std::min(nearest_m, glm::distance(*i, p));
  return nearest_m;
}

}  // namespace

std::vector<std::vector<glm::vec2>> parts_of_skin(const scene::AssetData& scene,
                                                  std::span<const scene::SkinMesh> skin) {
  std::vector<std::vector<glm::vec2>> parts;
  for (const scene::SkinMesh& mesh : skin) parts.emplace_back(mesh.vertices.size(), glm::vec2(-1));
  Steps steps("finding nose and ears", skin.size() + 1);
  const rays::RayScene rays(scene);
  const std::optional<HeadFrame> frame = HeadFrame::find(rays);
  steps.done();
  if (!frame) return parts;

  Points ears;
  for (const scene::SkinMesh& mesh : skin) {
    const Points thin = thin_points(rays, *frame, mesh);
    ears.insert(ears.end(), thin.begin(), thin.end());
    steps.done();
  }
  std::sort(ears.begin(), ears.end(), [](const auto& a, const auto& b) { return a.y < b.y; });

  // Farther out than that, the sign is enough.
  const double reach_m = frame->ear_closing_m(), reach = reach_m / frame->half_breadth_m();
  for (std::size_t i = 0; i < skin.size(); ++i)
    parallel_for(skin[i].vertices.size(), [&](std::size_t v) {
      const glm::dvec3 p(skin[i].vertices[v].position_m);
      double in_ear = frame->inside_sides(p);
      if (in_ear > -reach)
        in_ear = std::min(in_ear, reach - distance_m(ears, p, 2 * reach_m) / frame->half_breadth_m());
      parts[i][v] = {static_cast<float>(frame->inside_nose(p)), static_cast<float>(in_ear)};
    });
  return parts;
}

}  // namespace dermis::regions
