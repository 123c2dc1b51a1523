// SPDX-License-Identifier: MIT
#include <algorithm>

#include "head/scene/import/material_source.h"
#include "head/scene/surface/unwrap.h"
#include "render/setup/placed_scene.h"

namespace dermis::setup {
namespace {

bool is_as_its_asset(const PlacedInstance& instance) {
  return instance.visible && instance.world_from_asset.is_identity() && !instance.profile && !instance.mix &&
         !instance.posed && instance.tint == glm::vec3(1);
}

void offset_images(scene::Material& material, int first) {
  scene::for_each_map(material, [&](scene::MapRef& map, bool) {
    if (map.present()) map.image += first;
  });
}

scene::Material dressed(scene::Material material, const PlacedInstance& instance) {
  if (!material.skin) return material;
  if (instance.profile) material.skin_settings.profile = instance.profile;
  if (instance.mix) material.skin_settings.mix = instance.mix;
  material.base_colour *= glm::vec4(instance.tint, 1);
  // Bumps grow with the head.
  material.skin_settings.displacement_mm *= instance.world_from_asset.scale;
  return material;
}

// Vertices of skin and of what has one copy are moved; shared meshes have their placements moved.
void move(scene::Primitive& primitive, const scene::Similarity& world_from_asset) {
  for (scene::Placement& placement : primitive.placements) {
    const glm::mat4x3 m = world_from_asset.matrix();
    const glm::dmat4 world(glm::dvec4(m[0], 0), glm::dvec4(m[1], 0), glm::dvec4(m[2], 0),
                           glm::dvec4(m[3], 1));
    const glm::dmat4x3& old = placement.world_from_mesh;
    for (glm::length_t c = 0; c < 4; ++c)
      placement.world_from_mesh[c] = glm::dvec3(world * glm::dvec4(old[c], c == 3 ? 1 : 0));
  }
  if (!primitive.placements.empty()) return;

  for (scene::Vertex& vertex : primitive.vertices) {
    vertex.position_m = world_from_asset.position(vertex.position_m);
    vertex.normal = world_from_asset.direction(vertex.normal);
    vertex.tangent = glm::vec4(world_from_asset.direction(glm::vec3(vertex.tangent)), vertex.tangent.w);
  }
}

int greatest_node(const scene::AssetData& asset) {
  int most = -1;
  for (const scene::Primitive& primitive : asset.primitives) {
    most = std::max(most, primitive.node);
    for (const scene::Placement& placement : primitive.placements) most = std::max(most, placement.node);
  }
  return most;
}

}  // namespace

std::shared_ptr<const scene::AssetData> flattened(const PlacedScene& scene) {
  if (scene.instances.size() == 1 && is_as_its_asset(scene.instances.front()))
    return scene.instances.front().asset;

  auto flat = std::make_shared<scene::AssetData>();
  flat->name = scene.name;
  int first_node = 0;
  for (const PlacedInstance& instance : scene.instances) {
    if (!instance.visible) continue;
    const scene::AssetData& asset = *instance.asset;
    const auto first_image = static_cast<int>(flat->images.size());
    const auto first_material = static_cast<int>(flat->materials.size());
    flat->images.insert(flat->images.end(), asset.images.begin(), asset.images.end());
    for (const scene::Material& material : asset.materials) {
      flat->materials.push_back(dressed(material, instance));
      offset_images(flat->materials.back(), first_image);
    }

    scene::AssetData moved;
    if (instance.posed) {
      moved.primitives = asset.primitives;
      moved.cameras = asset.cameras;
      moved.lights = asset.lights;
      scene::take_pose(*asset.rig, instance.posed->rig, moved);
    }
    for (scene::Primitive primitive : instance.posed ? moved.primitives : asset.primitives) {
      primitive.material += first_material;
      if (primitive.node >= 0) primitive.node += first_node;
      for (scene::Placement& placement : primitive.placements)
        if (placement.node >= 0) placement.node += first_node;
      move(primitive, instance.world_from_asset);
      flat->primitives.push_back(std::move(primitive));
    }
    first_node += greatest_node(asset) + 1;
  }
  flat->skin = scene::skin_meshes(*flat);
  return flat;
}

}  // namespace dermis::setup
