// SPDX-License-Identifier: MIT
// KHR_materials_pbrSpecularGlossiness has how smooth a material is in the alpha of a map.
#include <algorithm>
#include <cmath>
#include <map>

#include "scene/gltf/finish.h"

namespace dermis::scene::gltf {
namespace {

// Roughness in green and no metal, as glTF's own map has them.
MapImage turned(const MapImage& glossiness, float factor) {
  image::Image8 roughness = *glossiness.pixels;
  for (std::size_t i = 0; i < roughness.rgba.size(); i += 4) {
    const float smooth = factor * static_cast<float>(roughness.rgba[i + 3]);
    roughness.rgba[i] = 255;
    roughness.rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255 - smooth));
    roughness.rgba[i + 2] = 0;
    roughness.rgba[i + 3] = 255;
  }
  return {glossiness.name + " as roughness", std::make_shared<const image::Image8>(std::move(roughness))};
}

}  // namespace

void turn_glossiness(const std::vector<std::optional<float>>& factors, Scene& scene) {
  std::map<std::pair<int, float>, int> done;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    Material& material = scene.materials[i];
    MapRef& map = material.metallic_roughness_map;
    if (!factors[i] || !map.present()) continue;

    const auto [entry, is_new] =
        done.try_emplace({map.image, *factors[i]}, static_cast<int>(scene.images.size()));
    if (is_new)
      scene.images.push_back(turned(scene.images[static_cast<std::size_t>(map.image)], *factors[i]));
    map.image = entry->second;
    material.roughness = 1;
  }
}

}  // namespace dermis::scene::gltf
