// SPDX-License-Identifier: MIT
// Materials as a file or a host gives them, and which of them are skin.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// A material as given; MapRef::image is still a number of its source.
struct MaterialSource {
  Material material;
  std::optional<bool> says_skin;  ///< whether it says itself that it is skin
  bool has_ior = false;
  /// Factor on the alpha of metallic_roughness_map, which says how smooth the material is; none: that map is
  /// as Material says.
  std::optional<float> glossiness{};
};

/// Returns the material of a primitive that names none: glTF's default.
MaterialSource default_material();

/// Materials of a source that nothing shows.
struct UnusedMaterials {
  std::size_t count = 0;
  std::optional<std::string> skin{};  ///< name of the first that says, or is called, that it is skin
  void add(const MaterialSource& material);
};

/// Decides which of the materials in use are skin: those that match one of `patterns` (SceneOptions), else
/// those that say so, else those whose name has "skin" as a word. Else it is the only one, unless an unused
/// one says or is called so. Gives skin its default index of refraction. Warns if there is none, and if the
/// only one in use is not the only one. Blended skin is drawn as a surface, with a warning that names it.
/// `file` is for messages. Throws InputError if a pattern matches nothing.
void choose_skin(const std::string& file, const std::vector<std::string>& patterns,
                 const UnusedMaterials& unused, std::vector<MaterialSource>& materials);

/// Calls visit(map, colour) for every map of a material, present or not; `colour`: the map holds colours in
/// sRGB. The only list of them.
template <class MaterialOrConst, class Visit>
void for_each_map(MaterialOrConst& m, const Visit& visit) {
  for (auto* map : {&m.base_colour_map, &m.emissive_map, &m.specular_colour_map}) visit(*map, true);
  for (auto* map :
       {&m.metallic_roughness_map, &m.normal_map, &m.occlusion_map, &m.specular_map, &m.transmission_map})
    visit(*map, false);
  for (auto* map : {&m.skin_settings.specular, &m.skin_settings.roughness, &m.skin_settings.displacement,
                    &m.skin_settings.detail})
    visit(*map, false);
}

}  // namespace dermis::scene
