// SPDX-License-Identifier: MIT
#include "head/scene/surface/fine_normals.h"

#include <algorithm>

#include "head/scene/surface/displacement.h"

namespace dermis::scene {

std::optional<image::Image8> fine_normals(const AssetData& scene, std::size_t material) {
  const Material& m = scene.materials[material];
  const MapRef& map = m.skin_settings.displacement;
  if (!m.skin || !map.present() || m.skin_settings.displacement_mm == 0) return std::nullopt;

  const auto mesh = std::find_if(scene.skin.begin(), scene.skin.end(), [&](const SkinMesh& s) {
    return std::find(s.triangle_material.begin(), s.triangle_material.end(), static_cast<int>(material)) !=
           s.triangle_material.end();
  });
  if (mesh == scene.skin.end()) return std::nullopt;

  DisplacementSettings settings;
  settings.displacement_mm = m.skin_settings.displacement_mm * map.scale;
  settings.channel = map.channel;
  settings.wrap_u = map.wrap_u;
  settings.wrap_v = map.wrap_v;
  settings.base_scale = m.normal_map.scale;

  // mm per unit of the map's own coordinates: mm per unit of the unwrap, corrected for the scale of the
  // unwrap and of the map's transform.
  const glm::dvec2 per_unwrap = mean_mm_per_uv(*mesh, scene.mm_per_unit);
  const glm::dvec2 transform(glm::length(map.transform[0]), glm::length(map.transform[1]));
  settings.mm_per_uv = per_unwrap * mesh->unwrap_scale / glm::max(transform, glm::dvec2(1e-6));

  const image::Image8* base = m.normal_map.present()
                                  ? scene.images[static_cast<std::size_t>(m.normal_map.image)].pixels.get()
                                  : nullptr;
  return displaced_normals(*scene.images[static_cast<std::size_t>(map.image)].pixels, settings, base);
}

}  // namespace dermis::scene
