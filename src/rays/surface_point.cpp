// SPDX-License-Identifier: MIT
// Based on: [H21] Hanika: Hacking the Shadow Terminator. Ray Tracing Gems II, 2021, ch. 4
#include "rays/surface_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "head/scene/placement.h"

namespace dermis::rays {
namespace {

struct Corners {
  std::array<scene::Vertex, 3> placed;  ///< only of a primitive with placements
  const scene::Vertex *a = nullptr, *b = nullptr, *c = nullptr;
};

void find_corners(const scene::AssetData& scene, const Hit& hit, Corners& corners) {
  const scene::Primitive& p = scene.primitives[hit.primitive];
  const std::uint32_t* index = &p.indices[3 * static_cast<std::size_t>(hit.triangle)];
  corners.a = &p.vertices[index[0]];
  corners.b = &p.vertices[index[1]];
  corners.c = &p.vertices[index[2]];
  if (p.placements.empty()) return;

  // The weights of a hit refer to the corners as the mesh orders them, also for a mirrored copy.
  for (std::size_t k = 0; k < 3; ++k) corners.placed[k] = scene::world_vertex(p, hit.copy, index[k]);
  corners.a = &corners.placed[0];
  corners.b = &corners.placed[1];
  corners.c = &corners.placed[2];
}

bool is_mirrored(const scene::AssetData& scene, const Hit& hit) {
  const scene::Primitive& p = scene.primitives[hit.primitive];
  return !p.placements.empty() && p.placements[hit.copy].mirrored;
}

glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length2 = glm::dot(v, v);
  return length2 > 1e-300 && std::isfinite(length2) ? v / std::sqrt(length2) : otherwise;
}

}  // namespace

SurfacePoint surface_point(const scene::AssetData& scene, const Hit& hit) {
  Corners corners;
  find_corners(scene, hit, corners);
  const auto [a, b, c] = std::tie(corners.a, corners.b, corners.c);
  const double w = 1 - hit.u - hit.v;
  const auto mix3 = [&](const glm::vec3& x, const glm::vec3& y, const glm::vec3& z) {
    return w * glm::dvec3(x) + hit.u * glm::dvec3(y) + hit.v * glm::dvec3(z);
  };
  const auto mix2 = [&](const glm::vec2& x, const glm::vec2& y, const glm::vec2& z) {
    return w * glm::dvec2(x) + hit.u * glm::dvec2(y) + hit.v * glm::dvec2(z);
  };

  SurfacePoint s;
  s.material = static_cast<std::size_t>(scene.primitives[hit.primitive].material);
  const glm::dvec3 pa(a->position_m), pb(b->position_m), pc(c->position_m);
  s.position_m = w * pa + hit.u * pb + hit.v * pc;
  const double winding = is_mirrored(scene, hit) ? -1 : 1;
  s.face_normal = unit_or(winding * glm::cross(pb - pa, pc - pa), glm::dvec3(0, 0, 1));
  s.normal = unit_or(mix3(a->normal, b->normal, c->normal), s.face_normal);
  s.tangent = w * glm::dvec4(a->tangent) + hit.u * glm::dvec4(b->tangent) + hit.v * glm::dvec4(c->tangent);
  s.uv = {mix2(a->uv0, b->uv0, c->uv0), mix2(a->uv1, b->uv1, c->uv1)};
  s.colour = w * glm::dvec4(a->colour) + hit.u * glm::dvec4(b->colour) + hit.v * glm::dvec4(c->colour);

  // [H21]: a flat triangle with interpolated normals shadows itself near the terminator, so rays start from
  // the rounded surface instead.
  const auto lift = [&](const scene::Vertex& v, const glm::dvec3& at) {
    return std::min(0.0, glm::dot(s.position_m - at, glm::dvec3(v.normal))) * glm::dvec3(v.normal);
  };
  s.shadow_origin_m = s.position_m - (w * lift(*a, pa) + hit.u * lift(*b, pb) + hit.v * lift(*c, pc));
  return s;
}

}  // namespace dermis::rays
