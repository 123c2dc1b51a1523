// SPDX-License-Identifier: MIT
// Reads images, samplers, textures and materials with their extensions.
#include <cmath>

#include "base/core/warnings.h"
#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"
#include "head/scene/import/limits.h"

namespace dermis::scene::gltf {

namespace {

AssetWrap read_wrap(const Value& sampler, const char* key) {
  switch (static_cast<int>(number_near(sampler, key, 10497))) {
    case 10497: return AssetWrap::repeat;
    case 33071: return AssetWrap::clamp;
    case 33648: return AssetWrap::mirror;
    default: warn_at(sampler.at(key), "is no way to wrap that glTF knows; the picture is repeated");
  }
  return AssetWrap::repeat;
}

Texture read_sampler(const Value& value) {
  Texture sampler;
  sampler.wrap_u = read_wrap(value, "wrapS");
  sampler.wrap_v = read_wrap(value, "wrapT");
  sampler.nearest = number_near(value, "magFilter", 9729) == 9728;
  return sampler;
}

// A picture says by its first bytes of which type it is.
void read_image(const Document& document, const Value& value, ImageSource& image) {
  image.name = text_near(value, "name", value.place());
  image.view = value.index_or_none("bufferView", document.views.size(), "bufferView");
  const std::optional<Value> uri = value.find("uri");
  if (image.view >= 0) return check_fault(document.views[static_cast<std::size_t>(image.view)].fault);
  if (!uri) value.fail("must have either a uri or a bufferView");
  image.uri = uri->text();
  if (!value.has("name") && !image.uri->starts_with("data:")) image.name = *image.uri;
}

/// uv' = translation * rotation * scale * uv
glm::mat3x2 read_texture_transform(const Value& value) {
  const std::vector<double> offset = numbers_near(value, "offset", 2),
                            scale = numbers_near(value, "scale", 2);
  const double rotation = number_near(value, "rotation", 0);
  const double su = scale.empty() ? 1 : scale[0], sv = scale.empty() ? 1 : scale[1];
  const double c = std::cos(rotation), s = std::sin(rotation);
  // The text of the extension rotates counter-clockwise in a picture whose v points down; its GLSL excerpt
  // has the signs of the sine reversed. Its test model, three.js and the Khronos viewer agree with these.
  return {glm::vec2(su * c, -su * s), glm::vec2(sv * s, sv * c),
          offset.empty() ? glm::vec2(0) : glm::vec2(offset[0], offset[1])};
}

MapRef map_member(const Document& document, const Value& value, const char* key,
                  const char* scale_key = nullptr) {
  MapRef map;
  const std::optional<Value> info = value.find(key);
  if (!info) return map;
  const std::string fault = fault_of([&] { map = read_texture_info(document, *info, scale_key); });
  if (!fault.empty()) {
    map = {};
    warn_of_fault(document.file, "maps that cannot be read are left out", info->place(), fault,
                  "the map is left out");
  }
  return map;
}

glm::vec3 colour_member(const Value& value, const char* key, const glm::vec3& otherwise, float most) {
  const std::vector<double> c = numbers_near(value, key, 3, 0, most);
  return c.empty() ? otherwise : glm::vec3(c[0], c[1], c[2]);
}

float factor(const Value& value, const char* key, double otherwise, double most = 1) {
  return static_cast<float>(number_near(value, key, otherwise, 0, most));
}

void read_metallic_roughness(const Document& document, const Value& value, Material& material) {
  const std::vector<double> colour = numbers_near(value, "baseColorFactor", 4, 0, 1);
  for (glm::length_t i = 0; i < 4 && !colour.empty(); ++i)
    material.base_colour[i] = static_cast<float>(colour[static_cast<std::size_t>(i)]);
  material.base_colour_map = map_member(document, value, "baseColorTexture");
  material.metallic = factor(value, "metallicFactor", 1);
  material.roughness = factor(value, "roughnessFactor", 1);
  material.metallic_roughness_map = map_member(document, value, "metallicRoughnessTexture");
}

/// Reads specular-glossiness, which older scans have. The map's alpha says how smooth skin is, and becomes
/// the roughness once it is decoded (turn_glossiness()). Its specular colour is left out: skin has its own.
void read_specular_glossiness(const Document& document, const Value& value, MaterialSource& source) {
  Material& material = source.material;
  const std::vector<double> diffuse = numbers_near(value, "diffuseFactor", 4, 0, 1);
  for (glm::length_t i = 0; i < 4 && !diffuse.empty(); ++i)
    material.base_colour[i] = static_cast<float>(diffuse[static_cast<std::size_t>(i)]);
  material.base_colour_map = map_member(document, value, "diffuseTexture");
  material.metallic = 0;
  source.glossiness = factor(value, "glossinessFactor", 1);
  material.roughness = 1 - *source.glossiness;
  material.metallic_roughness_map = map_member(document, value, "specularGlossinessTexture");
}

/// A shell in front of something, as a cornea. Of its map the mean counts (average_transmission()).
void read_transmission(const Document& document, const Value& value, Material& material) {
  material.transmission = factor(value, "transmissionFactor", 0);
  material.transmission_map = map_member(document, value, "transmissionTexture");
}

void read_material_extensions(const Document& document, const Value& value, MaterialSource& source) {
  Material& material = source.material;

  if (const auto strength = extension(value, "KHR_materials_emissive_strength"))
    material.emissive *= factor(*strength, "emissiveStrength", 1, largest_radiance);

  if (const auto ior = extension(value, "KHR_materials_ior")) {
    source.has_ior = true;
    material.ior = factor(*ior, "ior", 1.5, largest_ior);
    // 0 means "Fresnel of 1 everywhere", as for an infinite index.
    if (material.ior == 0) material.ior = largest_ior;
    if (material.ior < 1) {
      warn_at(*ior, "ior must be 0 or at least 1, which is taken");
      material.ior = 1;
    }
  }

  if (const auto specular = extension(value, "KHR_materials_specular")) {
    material.specular = factor(*specular, "specularFactor", 1);
    material.specular_map = map_member(document, *specular, "specularTexture");
    material.specular_map.channel = 3;
    material.specular_colour =
        colour_member(*specular, "specularColorFactor", glm::vec3(1), largest_radiance);
    material.specular_colour_map = map_member(document, *specular, "specularColorTexture");
  }

  if (const auto transmission = extension(value, "KHR_materials_transmission"))
    read_transmission(document, *transmission, material);
  material.unlit = extension(value, "KHR_materials_unlit").has_value();
}

AssetAlpha read_alpha_mode(const Value& value) {
  const std::string mode = text_near(value, "alphaMode", "OPAQUE");
  if (mode == "OPAQUE") return AssetAlpha::opaque;
  if (mode == "MASK") return AssetAlpha::mask;
  if (mode == "BLEND") return AssetAlpha::blend;
  warn_at(value.at("alphaMode"), "is none of OPAQUE, MASK and BLEND; it is drawn opaque");
  return AssetAlpha::opaque;
}

MaterialSource read_material(const Document& document, const Value& value) {
  MaterialSource source;
  Material& material = source.material;
  material.name = text_near(value, "name", "");

  const std::optional<Value> pbr = value.find("pbrMetallicRoughness");
  const std::optional<Value> older = extension(value, "KHR_materials_pbrSpecularGlossiness");
  // Beside the extension it is what readers without the extension are to show.
  if (older)
    read_specular_glossiness(document, *older, source);
  else if (pbr && pbr->is_object())
    read_metallic_roughness(document, *pbr, material);
  material.normal_map = map_member(document, value, "normalTexture", "scale");
  material.occlusion_map = map_member(document, value, "occlusionTexture", "strength");
  material.emissive = colour_member(value, "emissiveFactor", glm::vec3(0), largest_radiance);
  material.emissive_map = map_member(document, value, "emissiveTexture");
  material.alpha_mode = read_alpha_mode(value);
  material.alpha_cutoff = factor(value, "alphaCutoff", 0.5, largest_cutoff);
  material.double_sided = boolean_near(value, "doubleSided", false);

  read_material_extensions(document, value, source);
  const std::optional<Value> extras = value.find("extras");
  if (extras && extras->is_object() && extras->has("dermis")) {
    const MapRef& shared =
        material.base_colour_map.present() ? material.base_colour_map : material.normal_map;
    read_dermis_extras(document, extras->at("dermis"), shared, source);
  }
  return source;
}

}  // namespace

MapRef map_of_texture(const Document& document, int texture, const Value& where) {
  const Texture& t = document.textures[texture];
  MapRef map;
  map.image = t.image;
  map.wrap_u = t.wrap_u;
  map.wrap_v = t.wrap_v;
  map.nearest = t.nearest;
  if (t.image < 0)
    warn_of(fmt::format("{}: textures without a PNG or JPEG picture, their maps are left out", document.file),
            where.place(),
            fmt::format("{}: {}: texture {} has no PNG or JPEG picture, the map is left out", document.file,
                        where.place(), texture));
  return map;
}

MapRef read_texture_info(const Document& document, const Value& info, const char* scale_key) {
  MapRef map = map_of_texture(document, info.index("index", document.textures.size(), "texture"), info);
  std::uint64_t set = info.count_or("texCoord", 0, 0, 1000);
  if (scale_key != nullptr) map.scale = static_cast<float>(number_near(info, scale_key, 1));
  if (const auto transform = extension(info, "KHR_texture_transform")) {
    map.transform = read_texture_transform(*transform);
    set = transform->count_or("texCoord", set, 0, 1000);
  }
  if (set > 1) {
    warn_of(fmt::format("{}: maps with texture coordinates beyond sets 0 and 1 are left out", document.file),
            info.place(),
            fmt::format("{}: {}: uses TEXCOORD_{}; only sets 0 and 1 are read, the map is left out",
                        document.file, info.place(), set));
    return {};
  }
  map.uv_set = static_cast<int>(set);
  return map;
}

void read_textures(Document& document, const Value& root) {
  root.for_each("images", [&](const Value& value) {
    ImageSource& image = document.images.emplace_back();
    image.fault = fault_of([&] { read_image(document, value, image); });
  });
  std::vector<Texture> samplers;
  const std::string fault = fault_of([&] {
    root.for_each("samplers", [&](const Value& value) { samplers.push_back(read_sampler(value)); });
  });
  if (!fault.empty())
    warn_of_fault(document.file, "samplers that cannot be read are left out", "samplers", fault,
                  "pictures repeat, and are filtered");
  root.for_each("textures", [&](const Value& value) {
    const int sampler = index_near(value, "sampler", samplers.size(), "sampler");
    Texture texture = sampler >= 0 ? samplers[sampler] : Texture{};
    // KTX2 and WebP pictures of an extension are not read, but the plain source beside them is.
    texture.image = index_near(value, "source", document.images.size(), "image");
    document.textures.push_back(texture);
  });
}

void read_materials(Document& document, const Value& root) {
  root.for_each("materials",
                [&](const Value& value) { document.materials.push_back(read_material(document, value)); });
}

}  // namespace dermis::scene::gltf
