// SPDX-License-Identifier: MIT
// Decoded maps become those that are drawn. KHR_materials_pbrSpecularGlossiness has how smooth a material
// is in the alpha of a map; of KHR_materials_transmission's map the mean counts.
#include <algorithm>
#include <cmath>
#include <map>

#include "head/scene/gltf/finish.h"
#include "head/scene/gltf/lenient.h"

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

std::pair<int, int> range_of_red(const image::Image8& map) {
  std::pair<int, int> range{255, 0};
  for (std::size_t i = 0; i < map.rgba.size(); i += 4)
    range = {std::min<int>(range.first, map.rgba[i]), std::max<int>(range.second, map.rgba[i])};
  return range;
}

float mean_of_red(const image::Image8& map) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < map.rgba.size(); i += 4) sum += map.rgba[i];
  return static_cast<float>(sum) / (255.0f * static_cast<float>(map.rgba.size() / 4));
}

}  // namespace

void average_transmission(const std::string& file, AssetData& scene) {
  for (Material& material : scene.materials) {
    if (!material.transmission_map.present()) continue;
    const image::Image8& map =
        *scene.images[static_cast<std::size_t>(material.transmission_map.image)].pixels;
    const auto [least, most] = range_of_red(map);
    if (material.transmission > 0 && most - least > 2)
      warn_at(file, fmt::format("material '{}'", material.name),
              "lets light through by a map; the mean of the map counts everywhere");
    material.transmission *= mean_of_red(map);
    material.transmission_map = {};
  }
}

void turn_glossiness(const std::vector<std::optional<float>>& factors, AssetData& scene) {
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
