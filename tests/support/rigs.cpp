// SPDX-License-Identifier: MIT
#include "support/rigs.h"

#include <vector>

namespace dermis::tests {
namespace {

scene::RigMesh morphing_mesh(const scene::Primitive& primitive,
                             const std::function<glm::vec3(const glm::vec3&)>& moved) {
  scene::RigMesh mesh;
  const auto begin = [&] {
    mesh.first_influence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
    mesh.first_delta.push_back(static_cast<std::uint32_t>(mesh.deltas.size()));
  };
  for (const scene::Vertex& v : primitive.vertices) {
    begin();
    mesh.positions.push_back(v.position_m);
    mesh.normals.push_back(v.normal);
    mesh.tangents.emplace_back(v.tangent);
    mesh.influences.push_back({.matrix = 0, .weight = 1});
    mesh.deltas.push_back({.weight = 0, .position = moved(v.position_m) - v.position_m});
  }
  begin();
  return mesh;
}

}  // namespace

std::shared_ptr<const scene::Rig> morphing(const scene::AssetData& made,
                                           const std::function<glm::vec3(const glm::vec3&)>& moved) {
  auto rig = std::make_shared<scene::Rig>();
  rig->rest.resize(1);
  rig->rest[0].weights = {0};
  rig->meshes.push_back(morphing_mesh(made.primitives.front(), moved));
  for (std::size_t p = 1; p < made.primitives.size(); ++p) {
    const scene::Primitive& primitive = made.primitives[p];
    scene::RigMesh& mesh = rig->meshes.emplace_back();
    for (const scene::Vertex& v : primitive.vertices) mesh.positions.push_back(v.position_m);
    for (const scene::Placement& placement : primitive.placements) {
      mesh.placed.push_back(static_cast<std::uint32_t>(rig->rest.size()));
      rig->rest.push_back(
          {.transform = {.translation = glm::dvec3(placement.world_from_mesh[3])}, .weights = {}});
    }
  }

  rig->nodes.resize(rig->rest.size());
  rig->first_weight.assign(rig->rest.size() + 1, 1);
  rig->first_weight.front() = 0;
  for (std::size_t node = 0; node < rig->rest.size(); ++node) {
    rig->order.push_back(static_cast<int>(node));
    rig->matrices.push_back({.node = static_cast<int>(node)});
  }
  std::vector<bool> skin(made.primitives.size(), false);
  skin.front() = true;
  scene::fill_bounds(*rig, skin);
  return rig;
}

}  // namespace dermis::tests
