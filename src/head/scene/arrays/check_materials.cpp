// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/core/error.h"
#include "head/scene/arrays/check.h"
#include "head/scene/import/limits.h"
#include "tissue/gaussians/scatter_profile.h"

namespace dermis::scene::arrays {

namespace {

/// Holds the members of one material against their ranges.
class MaterialCheck {
 public:
  MaterialCheck(const AssetArrays& arrays, std::size_t number)
      : where_(name_of(arrays) + ": " + place_of("material", number, arrays.materials[number].name)),
        images_(arrays.images.size()) {}

  const std::string& where() const { return where_; }

  void number(const char* member, double value, double least, double most) const {
    if (!(value >= least && value <= most))
      throw input_error(where_, "{} must be {} to {}, got {}", member, least, most, value);
  }

  template <std::size_t N>
  void colour(const char* member, const std::array<float, N>& values, double most) const {
    for (const float value : values) number(member, value, 0, most);
  }

  void map(const char* member, const AssetMap& map) const {
    if (map.image < -1 || map.image >= static_cast<std::int64_t>(images_))
      throw input_error(where_, "{}.image is {}, there are {} images (-1 for none)", member, map.image,
                        images_);
    if (map.uv_set != 0 && map.uv_set != 1)
      throw input_error(where_, "{}.uv_set must be 0 or 1, got {}", member, map.uv_set);
    for (const auto& column : map.transform)
      for (const float value : column)
        if (!std::isfinite(value))
          throw input_error(where_, "{}.transform must be finite, has {}", member, value);
    for (const AssetWrap wrap : {map.wrap_u, map.wrap_v})
      if (wrap > AssetWrap::mirror)
        throw input_error(where_, "{} wraps in no known way: {}", member, static_cast<int>(wrap));
  }

  void channel_map(const char* member, const AssetChannelMap& channel) const {
    map(member, channel.map);
    if (channel.channel < 0 || channel.channel > 3)
      throw input_error(where_, "{}.channel must be 0 to 3, got {}", member, channel.channel);
    if (!(channel.scale >= 0 && channel.scale <= largest_map_factor))
      throw input_error(where_, "{}.scale must be 0 to {}, got {}", member, largest_map_factor,
                        channel.scale);
  }

 private:
  std::string where_;
  std::size_t images_;
};

void check_maps(const MaterialCheck& check, const AssetMaterial& m) {
  check.map("base_colour_map", m.base_colour_map);
  check.map("metallic_roughness_map", m.metallic_roughness_map);
  check.map("normal_map", m.normal_map);
  check.map("occlusion_map", m.occlusion_map);
  check.map("emissive_map", m.emissive_map);
  check.map("specular_map", m.specular_map);
  check.map("specular_colour_map", m.specular_colour_map);
}

void check_factors(const MaterialCheck& check, const AssetMaterial& m) {
  check.colour("base_colour", m.base_colour, 1);
  check.number("metallic", m.metallic, 0, 1);
  check.number("roughness", m.roughness, 0, 1);
  if (!std::isfinite(m.normal_scale))
    throw input_error(check.where(), "normal_scale must be finite, got {}", m.normal_scale);
  check.number("occlusion_strength", m.occlusion_strength, 0, 1);
  check.colour("emissive", m.emissive, largest_radiance);
  if (m.ior && *m.ior != 0) check.number("ior", *m.ior, 1, largest_ior);
  check.number("specular", m.specular, 0, 1);
  check.colour("specular_colour", m.specular_colour, largest_radiance);
  check.number("alpha_cutoff", m.alpha_cutoff, 0, largest_cutoff);
  if (m.alpha > AssetAlpha::blend)
    throw input_error(check.where(), "alpha is no known mode: {}", static_cast<int>(m.alpha));
}

void check_lobes(const MaterialCheck& check, const std::vector<AssetLobe>& lobes) {
  if (lobes.empty()) return;
  if (lobes.size() > most_lobes)
    throw input_error(check.where(), "lobes must be 1 or 2, got {}", lobes.size());

  double sum = 0;
  for (const AssetLobe& lobe : lobes) {
    if (!(lobe.roughness_factor > 0 && lobe.roughness_factor <= largest_lobe_factor))
      throw input_error(check.where(), "the roughness_factor of a lobe must be over 0 and up to {}, got {}",
                        largest_lobe_factor, lobe.roughness_factor);
    check.number("the weight of a lobe", lobe.weight, 0, 1);
    sum += lobe.weight;
  }
  if (std::abs(sum - 1) > lobe_weight_tolerance)
    throw input_error(check.where(), "the weights of the lobes must sum to 1, they sum to {:.6g}", sum);
}

void check_skin(const MaterialCheck& check, const AssetSkin& skin) {
  if (skin.profile) gaussians::checked_profile(*skin.profile, check.where() + ": profile");
  if (skin.mix) check.number("mix", *skin.mix, 0, 1);
  check.channel_map("specular", skin.specular);
  check.channel_map("roughness", skin.roughness);
  check.map("displacement", skin.displacement);
  check.number("displacement_mm", skin.displacement_mm, 0, largest_displacement_mm);
  check.number("displacement_middle", skin.displacement_middle, 0, 1);
  check.map("detail", skin.detail);
  check.number("detail_scale", skin.detail_scale, 0, largest_detail_scale);
  check_lobes(check, skin.lobes);
}

}  // namespace

void check_materials(const AssetArrays& arrays) {
  for (std::size_t i = 0; i < arrays.materials.size(); ++i) {
    const MaterialCheck check(arrays, i);
    check_maps(check, arrays.materials[i]);
    check_factors(check, arrays.materials[i]);
    check_skin(check, arrays.materials[i].skin_settings);
  }
}

}  // namespace dermis::scene::arrays
