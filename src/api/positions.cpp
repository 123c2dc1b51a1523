// SPDX-License-Identifier: MIT
#include <algorithm>
#include <glm/glm.hpp>
#include <limits>
#include <unordered_map>

#include "api/asset_state.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "head/scene/placement.h"
#include "head/scene/rig/rig.h"

namespace dermis {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A vertex of the asset as it is kept.
struct KeptVertex {
  std::size_t primitive = 0;
  std::uint32_t vertex = none;
};

// Where the vertices of a mesh of the source are kept: several primitives may have parts of it.
std::vector<KeptVertex> kept_vertices(const scene::AssetData& asset, int mesh,
                                      std::span<const std::uint32_t> vertices) {
  std::unordered_map<std::uint32_t, KeptVertex> found;
  for (const std::uint32_t vertex : vertices) found.emplace(vertex, KeptVertex{});

  bool known = false;
  for (std::size_t p = 0; p < asset.primitives.size(); ++p) {
    const scene::Primitive& primitive = asset.primitives[p];
    if (primitive.source_mesh != mesh) continue;
    known = true;
    if (scene::copies_of(primitive) > 1)
      throw input_error(asset.name, "mesh {} stands at {} nodes: its vertices have no one place", mesh,
                        scene::copies_of(primitive));
    for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
      const auto wanted = found.find(scene::source_vertex(primitive, v));
      if (wanted != found.end() && wanted->second.vertex == none) wanted->second = {p, v};
    }
  }
  if (!known) throw input_error(asset.name, "has no mesh {} with triangles that are kept", mesh);

  std::vector<KeptVertex> kept;
  for (const std::uint32_t vertex : vertices) {
    kept.push_back(found.at(vertex));
    if (kept.back().vertex == none)
      throw input_error(asset.name, "mesh {} has no vertex {} that a triangle uses", mesh, vertex);
  }
  return kept;
}

}  // namespace

std::vector<std::array<double, 3>> Scene::positions_m(InstanceId id, int mesh,
                                                      std::span<const std::uint32_t> vertices) const {
  const auto instance = std::ranges::find(state_->instances, id, &State::Entry::id);
  if (instance == state_->instances.end())
    throw input_error("", "no instance {} in this scene", static_cast<std::uint32_t>(id));
  const scene::AssetData& asset = *Asset::State::of(instance->instance.asset);

  std::vector<std::array<double, 3>> positions_m;
  for (const KeptVertex& kept : kept_vertices(asset, mesh, vertices)) {
    const glm::dvec3 in_asset_m =
        instance->placed.posed
            ? scene::posed_position_m(asset, instance->placed.posed->rig, kept.primitive, kept.vertex)
            : glm::dvec3(scene::world_position_m(asset.primitives[kept.primitive], 0, kept.vertex));
    const std::array<double, 16>& m = instance->instance.world_from_asset;
    std::array<double, 3>& world_m = positions_m.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      world_m[i] = m[i] * in_asset_m.x + m[4 + i] * in_asset_m.y + m[8 + i] * in_asset_m.z + m[12 + i];
  }
  return positions_m;
}

}  // namespace dermis
