// SPDX-License-Identifier: MIT
// Reads extras.dermis of a material: what glTF cannot express. Strict, because a mistyped key would silently
// render different skin.
#include <algorithm>
#include <cmath>

#include "base/core/known_names.h"
#include "head/scene/gltf/document.h"
#include "head/scene/import/limits.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/known.h"

namespace dermis::scene::gltf {

namespace {

/// Reads the number of a texture, which then uses the coordinates of the colour map (skin maps share one
/// unwrap), or a textureInfo object.
MapRef read_map(const Document& document, const Value& texture, const MapRef& shared) {
  if (texture.is_object()) return read_texture_info(document, texture);
  const std::uint64_t number = texture.count();
  if (number >= document.textures.size())
    texture.fail("there is no texture {} ({} in all)", number, document.textures.size());
  MapRef map = map_of_texture(document, static_cast<int>(number), texture);
  map.uv_set = shared.uv_set;
  map.transform = shared.transform;
  return map;
}

int read_channel(const Value& value) {
  if (!value.is_text()) return static_cast<int>(value.count(0, 3));
  static const std::string letters = "rgbaRGBA";
  const std::string& text = value.text();
  const std::size_t found = text.size() == 1 ? letters.find(text) : std::string::npos;
  if (found == std::string::npos)
    value.fail("must be 0 to 3 or one of R, G, B, A, is '{}'", text.substr(0, 20));
  return static_cast<int>(found % 4);
}

MapRef read_channel_map(const Document& document, const Value& value, const MapRef& shared, int channel) {
  value.only_keys({"texture", "channel", "scale"});
  MapRef map = read_map(document, value.at("texture"), shared);
  const std::optional<Value> given = value.find("channel");
  map.channel = given ? read_channel(*given) : channel;
  map.scale = static_cast<float>(value.number_or("scale", 1, 0, largest_map_factor));
  return map;
}

ScatterProfile read_profile(const Document& document, const Value& value) {
  if (value.is_object()) return gaussians::read_json(value);
  const std::string& name = value.text();
  const std::vector<std::string_view> known = gaussians::known_names();
  if (std::find(known.begin(), known.end(), name) != known.end()) return gaussians::known(name);
  if (std::filesystem::path(name).is_absolute())
    value.fail("the profile must be named relative to the scene");
  const std::filesystem::path path = document.folder / name;
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    value.fail("'{}' is neither a file beside the scene nor a published profile; {}", name.substr(0, 200),
               listed_names(name, known));
  return gaussians::load_json(path);
}

std::vector<SpecularLobe> read_lobes(const Value& value) {
  const std::size_t size = value.array_size();
  if (size > most_lobes) value.fail("must have 1 or 2 lobes, has {}", size);
  std::vector<SpecularLobe> lobes;
  double sum = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Value pair = value.element(i);
    if (pair.array_size() != 2) pair.fail("must be [factor on m, weight]");
    const double m_factor = pair.element(0).number(), weight = pair.element(1).number();
    if (!(m_factor > 0 && m_factor <= largest_lobe_factor))
      pair.fail("the factor on m must be over 0 and up to {}, is {}", largest_lobe_factor, m_factor);
    if (!(weight >= 0 && weight <= 1)) pair.fail("the weight must be 0 to 1, is {}", weight);
    lobes.push_back({static_cast<float>(m_factor), static_cast<float>(weight)});
    sum += weight;
  }
  if (std::abs(sum - 1) > lobe_weight_tolerance) value.fail("the weights must sum to 1, they sum to {}", sum);
  return lobes;
}

void read_displacement(const Document& document, const Value& value, const MapRef& shared,
                       SkinMaterial& into) {
  value.only_keys({"texture", "mm", "middle"});
  into.displacement = read_map(document, value.at("texture"), shared);
  value.at("mm");
  into.displacement_mm = static_cast<float>(value.number_or("mm", 0, 0, largest_displacement_mm));
  into.displacement_middle = static_cast<float>(value.number_or("middle", 0.5, 0, 1));
}

MapRef read_detail(const Document& document, const Value& value, const MapRef& shared) {
  value.only_keys({"texture", "scale"});
  MapRef map = read_map(document, value.at("texture"), shared);
  map.scale = static_cast<float>(value.number_or("scale", 1, 0, largest_detail_scale));
  return map;
}

}  // namespace

void read_dermis_extras(const Document& document, const Value& extras, const MapRef& shared,
                        MaterialSource& into) {
  extras.object().only_keys(
      {"skin", "profile", "mix", "specular", "roughness", "displacement", "detail", "lobes"});
  SkinMaterial& skin = into.material.skin_settings;
  into.says_skin = extras.boolean_or("skin", true);
  if (const auto profile = extras.find("profile")) skin.profile = read_profile(document, *profile);
  if (extras.has("mix")) skin.mix = static_cast<float>(extras.number_or("mix", 0, 0, 1));
  if (const auto specular = extras.find("specular"))
    skin.specular = read_channel_map(document, *specular, shared, 0);
  if (const auto roughness = extras.find("roughness"))
    skin.roughness = read_channel_map(document, *roughness, shared, 1);
  if (const auto displacement = extras.find("displacement"))
    read_displacement(document, *displacement, shared, skin);
  if (const auto detail = extras.find("detail")) skin.detail = read_detail(document, *detail, shared);
  if (const auto lobes = extras.find("lobes")) skin.lobes = read_lobes(*lobes);
}

}  // namespace dermis::scene::gltf
