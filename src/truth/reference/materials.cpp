// SPDX-License-Identifier: MIT
#include <map>

#include "base/core/hooks.h"
#include "head/scene/surface/fine_normals.h"
#include "head/scene/surface/unwrap.h"
#include "truth/reference/shading.h"

namespace dermis::reference {

std::vector<ShadingMaterial> shading_materials(const scene::AssetData& scene, std::optional<double> mix) {
  // Reads an image once per colour space; materials share the pixels.
  std::map<std::pair<int, bool>, std::shared_ptr<const MapPixels>> loaded;
  const auto slot = [&](const scene::MapRef& map, bool srgb) {
    MapSlot made{.map = map, .pixels = nullptr};
    if (!map.present()) return made;
    auto& pixels = loaded[{map.image, srgb}];
    if (!pixels)
      pixels =
          std::make_shared<const MapPixels>(*scene.images[static_cast<std::size_t>(map.image)].pixels, srgb);
    made.pixels = pixels;
    return made;
  };

  std::vector<ShadingMaterial> materials;
  Steps steps("reading materials", scene.materials.size());
  for (const scene::Material& m : scene.materials) {
    ShadingMaterial made{.source = &m, .skin = m.skin};
    made.mix_before = mix.value_or(m.skin_settings.mix_or_default());
    made.base_colour = slot(m.base_colour_map, true);
    made.normal = slot(m.normal_map, false);
    if (m.skin) made.detail = slot(m.skin_settings.detail, false);
    made.occlusion = slot(m.occlusion_map, false);
    made.emissive = slot(m.emissive_map, true);
    made.specular_colour = slot(m.specular_colour_map, true);
    made.specular = slot(m.skin ? m.skin_settings.specular : m.specular_map, false);
    made.roughness = slot(m.metallic_roughness_map, false);

    if (m.skin) {
      // If the skin names no roughness map of its own, glTF's metallic-roughness map is used: G times the
      // factor.
      made.roughness.map.channel = 1;
      made.roughness.map.scale = m.roughness;
      if (m.skin_settings.roughness.present()) made.roughness = slot(m.skin_settings.roughness, false);
    }

    if (auto normals = scene::fine_normals(scene, materials.size())) {
      made.normal = {.map = m.skin_settings.displacement,
                     .pixels = std::make_shared<const MapPixels>(std::move(*normals), false)};
      made.normal.map.scale = 1;
    }
    materials.push_back(std::move(made));
    steps.done();
  }
  return materials;
}

}  // namespace dermis::reference
