// SPDX-License-Identifier: MIT
#include "head/scene/import/complete.h"

#include <algorithm>

#include "base/core/hooks.h"
#include "head/scene/import/limits.h"
#include "head/scene/placement.h"
#include "head/scene/surface/tangents.h"

namespace dermis::scene {

namespace {

constexpr float least_height_m = 0.10f, most_height_m = 0.60f;

// Fine normals of a displacement map and tiles of detail use the tangents too; the normal map's coordinates
// count before theirs.
const MapRef& map_of_tangents(const Material& material) {
  const SkinMaterial& skin = material.skin_settings;
  return material.normal_map.present() ? material.normal_map
         : skin.displacement.present() ? skin.displacement
                                       : skin.detail;
}

void complete_surface(Primitive& primitive, const Material& material, bool has_tangents) {
  make_missing_normals(primitive);
  if (keeps_tangents(material, has_tangents)) return;
  const MapRef& map = map_of_tangents(material);
  make_tangents(primitive, map.transform, map.uv_set);
}

}  // namespace

bool keeps_tangents(const Material& material, bool has_tangents) {
  return has_tangents && map_of_tangents(material).transform == MapRef{}.transform;
}

void complete_surfaces(const std::vector<bool>& has_tangents, AssetData& scene) {
  Steps steps("completing surfaces", scene.primitives.size());
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    Primitive& primitive = scene.primitives[i];
    complete_surface(primitive, scene.materials[static_cast<std::size_t>(primitive.material)],
                     has_tangents[i]);
    steps.done();
  }
}

void check_skin_nodes(const std::string& file, std::size_t count) {
  if (count > most_skin_nodes)
    throw input_error(file,
                      "has {} nodes of skin, each with a light map of its own, and at most {} can be drawn. "
                      "Join their meshes, or name another material with skin_material",
                      count, most_skin_nodes);
}

void warn_of_size(const std::string& file, const AssetData& scene) {
  float low = 0, high = 0;
  bool any = false;

  for (const Primitive& p : scene.primitives) {
    if (!scene.materials[static_cast<std::size_t>(p.material)].skin) continue;
    for_each_position(p, [&](const glm::vec3& position_m) {
      low = any ? std::min(low, position_m.y) : position_m.y;
      high = any ? std::max(high, position_m.y) : position_m.y;
      any = true;
    });
  }

  const float height = high - low;
  if (any && (height < least_height_m || height > most_height_m)) {
    const std::string line = fmt::format(
        "{}: the skin is {:.4g} m high, a head has 0.1 to 0.6 m; light spreads by mm, so give the right size "
        "with unit_scale",
        file, height);
    warn_of(line, file, line);
  }
}

}  // namespace dermis::scene
