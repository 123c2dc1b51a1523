// SPDX-License-Identifier: MIT
#include "head/scene/gltf/finish.h"

#include "head/scene/views.h"

namespace dermis::scene::gltf {

namespace {

Camera place_camera(Camera camera, const Node& node, const glm::dmat4& world, double unit_scale) {
  if (camera.name.empty()) camera.name = node.name;
  stand_at(world, camera);
  const auto scale = static_cast<float>(unit_scale);
  camera.znear_m *= scale;
  camera.ymag_m *= scale;
  if (camera.zfar_m) *camera.zfar_m *= scale;
  return camera;
}

Light place_light(Light light, const Node& node, const glm::dmat4& world, double unit_scale) {
  if (light.name.empty()) light.name = node.name;
  const auto scale = static_cast<float>(unit_scale);
  stand_at(world, light);
  light.range_m *= scale;
  // The distance in colour / d^2 is scaled, and so must be the intensity: a change of units must not change
  // the brightness of the head.
  if (light.type != LightType::directional) {
    light.colour *= scale * scale;
    light.radius *= scale;
  }
  return light;
}

}  // namespace

std::vector<MaterialSource> used_materials(const Document& document, MaterialNumbers& numbers) {
  std::vector<bool> done(document.meshes.size(), false);
  for (const int n : shown_nodes(document)) {
    const int mesh = document.nodes[n].mesh;
    if (mesh < 0 || done[mesh]) continue;
    done[mesh] = true;
    for (const MeshPrimitive& p : document.meshes[mesh].primitives)
      if (claimed_triangles(document, p) > 0) numbers.of[p.material] = 0;
  }

  std::vector<MaterialSource> used;
  for (auto& [source, target] : numbers.of) {
    if (source < 0) continue;  // the default material is last, so that the others keep the file's order
    target = static_cast<int>(used.size());
    used.push_back(document.materials[source]);
  }
  if (numbers.of.contains(-1)) {
    numbers.of[-1] = static_cast<int>(used.size());
    used.push_back(default_material());
  }
  return used;
}

UnusedMaterials unused_materials(const Document& document, const MaterialNumbers& numbers) {
  UnusedMaterials unused;
  for (std::size_t i = 0; i < document.materials.size(); ++i)
    if (!numbers.of.contains(static_cast<int>(i))) unused.add(document.materials[i]);
  return unused;
}

ViewNodes place_lights_and_cameras(const Document& document, double unit_scale, AssetData& scene) {
  ViewNodes placed;
  const std::vector<glm::dmat4> world = world_matrices(document, unit_scale);
  for (const int n : shown_nodes(document)) {
    const Node& node = document.nodes[n];
    if (node.camera >= 0 && document.cameras[node.camera]) {
      scene.cameras.push_back(place_camera(*document.cameras[node.camera], node, world[n], unit_scale));
      placed.cameras.push_back(n);
    }
    if (node.light >= 0 && document.lights[node.light]) {
      scene.lights.push_back(place_light(*document.lights[node.light], node, world[n], unit_scale));
      placed.lights.push_back(n);
    }
  }
  return placed;
}

}  // namespace dermis::scene::gltf
