// SPDX-License-Identifier: MIT
#include "head/scene/arrays/read_material.h"

#include "head/scene/import/limits.h"
#include "tissue/gaussians/scatter_profile.h"

namespace dermis::scene::arrays {

namespace {

glm::vec3 vec3_of(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

MapRef map_of(const AssetMap& given, float scale = 1, int channel = 0) {
  if (given.image < 0) return {};
  MapRef map;
  map.image = given.image;
  map.uv_set = given.uv_set;
  for (glm::length_t column = 0; column < 3; ++column)
    for (glm::length_t row = 0; row < 2; ++row)
      map.transform[column][row] =
          given.transform[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
  map.wrap_u = given.wrap_u;
  map.wrap_v = given.wrap_v;
  map.nearest = given.nearest;
  map.channel = channel;
  map.scale = scale;
  return map;
}

MapRef map_of(const AssetChannelMap& given) { return map_of(given.map, given.scale, given.channel); }

SkinMaterial skin_of(const AssetSkin& given) {
  SkinMaterial skin;
  if (given.profile) skin.profile = gaussians::checked_profile(*given.profile);
  skin.mix = given.mix;
  skin.specular = map_of(given.specular);
  skin.roughness = map_of(given.roughness);
  skin.displacement = map_of(given.displacement);
  skin.displacement_mm = given.displacement_mm;
  skin.displacement_middle = given.displacement_middle;
  skin.detail = map_of(given.detail, given.detail_scale);

  if (given.lobes.empty()) return skin;
  skin.lobes.clear();
  for (const AssetLobe& lobe : given.lobes) skin.lobes.push_back({lobe.roughness_factor, lobe.weight});
  return skin;
}

}  // namespace

MaterialSource read_material(const AssetMaterial& given) {
  MaterialSource source;
  source.says_skin = given.skin;
  source.has_ior = given.ior.has_value();

  Material& m = source.material;
  m.name = given.name;
  m.base_colour = {given.base_colour[0], given.base_colour[1], given.base_colour[2], given.base_colour[3]};
  m.base_colour_map = map_of(given.base_colour_map);
  m.metallic = given.metallic;
  m.roughness = given.roughness;
  m.metallic_roughness_map = map_of(given.metallic_roughness_map);
  m.normal_map = map_of(given.normal_map, given.normal_scale);
  m.occlusion_map = map_of(given.occlusion_map, given.occlusion_strength);
  m.emissive = vec3_of(given.emissive);
  m.emissive_map = map_of(given.emissive_map);
  m.ior = given.ior.value_or(m.ior);
  if (m.ior == 0) m.ior = largest_ior;
  m.specular = given.specular;
  constexpr int alpha_channel = 3;
  m.specular_map = map_of(given.specular_map, 1, alpha_channel);
  m.specular_colour = vec3_of(given.specular_colour);
  m.specular_colour_map = map_of(given.specular_colour_map);
  m.alpha_mode = given.alpha;
  m.alpha_cutoff = given.alpha_cutoff;
  m.double_sided = given.double_sided;
  m.unlit = given.unlit;
  m.skin_settings = skin_of(given.skin_settings);
  return source;
}

}  // namespace dermis::scene::arrays
