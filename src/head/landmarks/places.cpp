// SPDX-License-Identifier: MIT
#include "head/landmarks/places.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_set>

#include "base/core/assert.h"
#include "head/scene/placement.h"

namespace dermis::landmarks {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Calls visit(primitive, its first corner in Primitive::indices) for each triangle of a mesh of the source.
template <class Visit>
void for_each_triangle(const scene::AssetData& asset, int mesh, const Visit& visit) {
  for (std::size_t p = 0; p < asset.primitives.size(); ++p) {
    if (asset.primitives[p].source_mesh != mesh) continue;
    for (std::size_t corner = 0; corner < asset.primitives[p].indices.size(); corner += 3) visit(p, corner);
  }
}

std::uint32_t source_corner(const scene::Primitive& primitive, std::size_t corner) {
  return scene::source_vertex(primitive, primitive.indices[corner]);
}

/// Returns the triangle from its lowest vertex on, sorted: files wind it either way.
Triangle sorted(Triangle triangle) {
  std::ranges::sort(triangle);
  return triangle;
}

/// Returns where a triangle of the source is kept, if it is.
std::optional<std::array<KeptVertex, 3>> find_triangle(const scene::AssetData& asset,
                                                       const LandmarkPlace& place) {
  std::optional<std::array<KeptVertex, 3>> found;
  for_each_triangle(asset, place.mesh, [&](std::size_t p, std::size_t corner) {
    const scene::Primitive& primitive = asset.primitives[p];
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = source_corner(primitive, corner + k);
    if (found || sorted(triangle) != sorted(place.vertices)) return;
    found.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::ranges::find(triangle, place.vertices[k]) - triangle.begin();
      (*found)[k] = {.primitive = p, .vertex = primitive.indices[corner + static_cast<std::size_t>(at)]};
    }
  });
  return found;
}

bool stands_once(const scene::AssetData& asset, int mesh) {
  return std::ranges::all_of(asset.primitives, [&](const scene::Primitive& primitive) {
    return primitive.source_mesh != mesh || scene::copies_of(primitive) == 1;
  });
}

}  // namespace

MeshSize size_of(const scene::AssetData& asset, int mesh) {
  std::unordered_set<std::uint32_t> vertices;
  MeshSize size{.mesh = mesh};
  for_each_triangle(asset, mesh, [&](std::size_t p, std::size_t corner) {
    ++size.triangles;
    for (std::size_t k = 0; k < 3; ++k) vertices.insert(source_corner(asset.primitives[p], corner + k));
  });
  size.vertices = vertices.size();
  return size;
}

std::string misfit(const Sidecar& sidecar, const scene::AssetData& asset) {
  for (const MeshSize& wanted : sidecar.meshes) {
    const MeshSize found = size_of(asset, wanted.mesh);
    if (found.vertices != wanted.vertices || found.triangles != wanted.triangles)
      return fmt::format(
          "mesh {} of {} has {} vertices and {} triangles, and the landmarks are of one with {} "
          "and {}",
          wanted.mesh, asset.name, found.vertices, found.triangles, wanted.vertices, wanted.triangles);
    if (!stands_once(asset, wanted.mesh))
      return fmt::format("mesh {} of {} stands at several nodes: its points have no one place", wanted.mesh,
                         asset.name);
  }
  for (std::size_t i = 0; i < sidecar.places.size(); ++i) {
    const LandmarkPlace& place = sidecar.places[i];
    if (!find_triangle(asset, place))
      return fmt::format("points[{}]: mesh {} of {} has no triangle {} {} {}", i, place.mesh, asset.name,
                         place.vertices[0], place.vertices[1], place.vertices[2]);
  }
  return {};
}

KeptPlaces kept_places(const Sidecar& sidecar, const scene::AssetData& asset) {
  KeptPlaces kept;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto found = find_triangle(asset, sidecar.places[i]);
    DERMIS_ASSERT(found.has_value());
    kept[i] = *found;
  }
  return kept;
}

}  // namespace dermis::landmarks
