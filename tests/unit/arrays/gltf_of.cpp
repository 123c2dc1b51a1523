// SPDX-License-Identifier: MIT
// Writes arrays as a glTF file.
#include <string_view>

#include "image/codec.h"
#include "support.h"

namespace dermis::scene::test {

namespace {

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63];
  }
  return text;
}

/// The picture as decoders see it: RGBA.
image::Image8 rgba_of(const AssetImage& given) {
  image::Image8 picture{.width = given.width, .height = given.height, .rgba = {}};
  const auto channels = static_cast<std::size_t>(given.channels);
  for (std::size_t i = 0; i < given.pixels.size(); i += channels) {
    const std::uint8_t* p = &given.pixels[i];
    const bool grey = channels < 3;
    picture.rgba.insert(picture.rgba.end(), {p[0], grey ? p[0] : p[1], grey ? p[0] : p[2],
                                             channels == 2   ? p[1]
                                             : channels == 4 ? p[3]
                                                             : std::uint8_t{255}});
  }
  return picture;
}

template <std::size_t N>
int accessor(Builder& b, std::span<const std::array<float, N>> values) {
  std::vector<float> flat;
  for (const auto& value : values) flat.insert(flat.end(), value.begin(), value.end());
  return b.accessor(flat, "VEC" + std::to_string(N));
}

void add_mesh(Builder& b, const AssetMesh& given) {
  Json attributes = {{"POSITION", accessor(b, given.positions_m)}};
  if (!given.normals.empty()) attributes["NORMAL"] = accessor(b, given.normals);
  if (!given.tangents.empty()) attributes["TANGENT"] = accessor(b, given.tangents);
  if (!given.uv0.empty()) attributes["TEXCOORD_0"] = accessor(b, given.uv0);
  if (!given.uv1.empty()) attributes["TEXCOORD_1"] = accessor(b, given.uv1);
  if (!given.colours.empty()) attributes["COLOR_0"] = accessor(b, given.colours);

  int indices = -1;
  if (!given.indices.empty())
    indices = b.accessor(std::vector<float>(given.indices.begin(), given.indices.end()), "SCALAR", 5125);
  const int mesh = b.mesh(attributes, indices);
  b.json["nodes"].back()["name"] = given.name;
  if (given.material >= 0)
    b.json["meshes"][static_cast<std::size_t>(mesh)]["primitives"][0]["material"] = given.material;
}

/// Adds the texture of a map; returns its textureInfo.
Json texture_of(Builder& b, const AssetMap& map, const char* scale_key = nullptr, float scale = 1) {
  const auto wrap = [](AssetWrap w) {
    return w == AssetWrap::clamp ? 33071 : w == AssetWrap::mirror ? 33648 : 10497;
  };
  b.json["samplers"].push_back(
      {{"wrapS", wrap(map.wrap_u)}, {"wrapT", wrap(map.wrap_v)}, {"magFilter", map.nearest ? 9728 : 9729}});
  b.json["textures"].push_back({{"source", map.image}, {"sampler", b.json["samplers"].size() - 1}});
  Json info = {{"index", b.json["textures"].size() - 1}, {"texCoord", map.uv_set}};
  if (scale_key != nullptr) info[scale_key] = scale;

  const auto& [u, v, offset] = map.transform;
  info["extensions"]["KHR_texture_transform"] = {{"scale", {u[0], v[1]}}, {"offset", offset}};
  return info;
}

Json skin_of(Builder& b, const AssetSkin& skin) {
  Json json = Json::object();
  if (skin.profile)
    for (const Gaussian& term : skin.profile->terms) {
      json["profile"]["variances_mm2"].push_back(term.variance_mm2);
      json["profile"]["weights"].push_back(term.weight);
    }
  if (skin.mix) json["mix"] = *skin.mix;
  const auto add = [&](const char* key, const AssetChannelMap& map) {
    if (map.map.image >= 0)
      json[key] = {{"texture", texture_of(b, map.map)}, {"channel", map.channel}, {"scale", map.scale}};
  };
  add("specular", skin.specular);
  add("roughness", skin.roughness);
  if (skin.displacement.image >= 0)
    json["displacement"] = {{"texture", texture_of(b, skin.displacement)},
                            {"mm", skin.displacement_mm},
                            {"middle", skin.displacement_middle}};
  if (skin.detail.image >= 0)
    json["detail"] = {{"texture", texture_of(b, skin.detail)}, {"scale", skin.detail_scale}};
  for (const AssetLobe& lobe : skin.lobes) json["lobes"].push_back({lobe.roughness_factor, lobe.weight});
  return json;
}

Json material_of(Builder& b, const AssetMaterial& m) {
  constexpr std::array modes{"OPAQUE", "MASK", "BLEND"};
  Json pbr = {
      {"baseColorFactor", m.base_colour}, {"metallicFactor", m.metallic}, {"roughnessFactor", m.roughness}};
  Json specular = {{"specularFactor", m.specular}, {"specularColorFactor", m.specular_colour}};
  Json json = {{"name", m.name},
               {"emissiveFactor", m.emissive},
               {"alphaMode", modes[static_cast<std::size_t>(m.alpha)]},
               {"alphaCutoff", m.alpha_cutoff},
               {"doubleSided", m.double_sided}};
  const auto add = [&](Json& to, const char* key, const AssetMap& map, const char* scale_key = nullptr,
                       float scale = 1) {
    if (map.image >= 0) to[key] = texture_of(b, map, scale_key, scale);
  };
  add(pbr, "baseColorTexture", m.base_colour_map);
  add(pbr, "metallicRoughnessTexture", m.metallic_roughness_map);
  add(json, "normalTexture", m.normal_map, "scale", m.normal_scale);
  add(json, "occlusionTexture", m.occlusion_map, "strength", m.occlusion_strength);
  add(json, "emissiveTexture", m.emissive_map);
  add(specular, "specularTexture", m.specular_map);
  add(specular, "specularColorTexture", m.specular_colour_map);

  json["pbrMetallicRoughness"] = pbr;
  json["extensions"]["KHR_materials_specular"] = specular;
  if (m.ior) json["extensions"]["KHR_materials_ior"] = {{"ior", *m.ior}};
  if (m.unlit) json["extensions"]["KHR_materials_unlit"] = Json::object();
  if (m.skin) {
    json["extras"]["dermis"] = skin_of(b, m.skin_settings);
    json["extras"]["dermis"]["skin"] = *m.skin;
  }
  return json;
}

}  // namespace

Builder gltf_of(const AssetArrays& given) {
  Builder b;
  for (const AssetMesh& mesh : given.meshes) add_mesh(b, mesh);
  for (const AssetImage& image : given.images)
    b.json["images"].push_back(
        {{"name", image.name},
         {"uri", "data:image/png;base64," + base64(image::encode_png(rgba_of(image), true))}});
  for (const AssetMaterial& material : given.materials)
    b.json["materials"].push_back(material_of(b, material));
  return b;
}

}  // namespace dermis::scene::test
