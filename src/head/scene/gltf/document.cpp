// SPDX-License-Identifier: MIT
#include "head/scene/gltf/document.h"

#include <algorithm>
#include <cctype>

#include "base/core/log.h"
#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {

namespace {

/// Extensions that a file may require. (Required or not, each is read wherever it occurs.)
constexpr std::array<std::string_view, 12> supported_extensions{
    "EXT_meshopt_compression",         "KHR_draco_mesh_compression", "KHR_lights_punctual",
    "KHR_materials_emissive_strength", "KHR_materials_ior",          "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_specular",          "KHR_materials_transmission", "KHR_materials_unlit",
    "KHR_mesh_quantization",           "KHR_node_visibility",        "KHR_texture_transform"};

struct Version {
  int major = 0, minor = 0;
};

Version read_version(const Value& value) {
  const std::string text = value.is_number() ? fmt::format("{:.1f}", value.number()) : value.text();
  const std::size_t dot = text.find('.');
  const auto digits = [](std::string_view s) {
    return !s.empty() && s.size() <= 4 &&
           std::all_of(s.begin(), s.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  };
  if (dot == std::string::npos || !digits(std::string_view(text).substr(0, dot)) ||
      !digits(std::string_view(text).substr(dot + 1)))
    value.fail("must be of the form \"2.0\", is \"{}\"", text.substr(0, 20));
  return {std::stoi(text.substr(0, dot)), std::stoi(text.substr(dot + 1))};
}

std::vector<std::string> names_in(const Value& root, const char* key) {
  const std::optional<Value> list = root.find(key);
  if (!list) return {};
  std::vector<std::string> names;
  for (std::size_t i = 0; list->is_array() && i < list->array_size(); ++i)
    if (list->element(i).is_text()) names.push_back(list->element(i).text());
  return names;
}

/// Returns whether a picture without an extension is one that somebody wants, though the file requires it. It
/// changes materials that are drawn in some way without it, or nothing that is seen.
bool is_dispensable(std::string_view name) {
  constexpr std::array<std::string_view, 4> prefixes{"KHR_materials_", "EXT_materials_", "KHR_xmp", "VRM"};
  constexpr std::array<std::string_view, 4> names{"KHR_animation_pointer", "KHR_node_selectability",
                                                  "KHR_node_hoverability", "EXT_lights_image_based"};
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](auto prefix) { return name.starts_with(prefix); }) ||
         std::find(names.begin(), names.end(), name) != names.end();
}

// A `{}` takes half a kilobyte as a node, and over one as a material.
void check_sizes(const Value& root) {
  constexpr std::pair<const char*, std::size_t> limits[] = {{"nodes", 1'000'000}, {"materials", 65'536}};
  for (const auto& [collection, most] : limits)
    if (const auto list = root.find(collection); list && list->is_array() && list->array_size(0) > most)
      list->fail("has {} elements, the limit is {}", list->array_size(0), most);
}

void read_versions(const Document& document, const Value& root) {
  const std::optional<Value> asset = root.find("asset");
  const std::optional<Value> given = asset ? asset->object().find("version") : std::nullopt;
  if (!given) {
    warn_in(document.file, "does not say its version, and is read as glTF 2.0");
    return;
  }
  const Version version = read_version(*given);
  if (version.major != 2)
    given->fail("glTF {}.{} is not supported, expected 2.0", version.major, version.minor);

  if (const std::optional<Value> least = asset->find("minVersion")) {
    const Version minimum = read_version(*least);
    if (minimum.major != 2 || minimum.minor != 0)
      least->fail("needs glTF {}.{}, this reader knows 2.0", minimum.major, minimum.minor);
  }
  if (version.minor != 0) warn_in(document.file, "glTF 2.{} is read as 2.0", version.minor);
}

}  // namespace

void read_header(Document& document, const Value& root) {
  read_versions(document, root);
  const auto is_supported = [](const std::string& name) {
    return std::find(supported_extensions.begin(), supported_extensions.end(), name) !=
           supported_extensions.end();
  };
  for (const std::string& name : names_in(root, "extensionsRequired")) {
    if (!is_supported(name) && is_dispensable(name))
      warn_in(document.file, "requires the extension {}, which is not read; the rest is drawn", name);
    else if (!is_supported(name))
      throw input_error(document.file, "requires the extension {}, which is not supported; supported are: {}",
                        name, fmt::join(supported_extensions, ", "));
  }

  std::vector<std::string> unread;
  for (const std::string& name : names_in(root, "extensionsUsed")) {
    if (!is_supported(name)) unread.push_back(name);
    document.quantized |= name == "KHR_mesh_quantization";
  }
  if (!unread.empty()) note("{}: optional extensions not read: {}", document.file, fmt::join(unread, ", "));
}

Document read_document(const Value& root, const Container& container, const std::filesystem::path& path) {
  Document document;
  document.file = path.string();
  document.folder = path.parent_path();
  read_header(document, root);
  check_sizes(root);
  read_buffers(document, root, container.binary.has_value());
  read_accessors(document, root);
  read_textures(document, root);
  read_materials(document, root);
  read_cameras(document, root);
  read_lights(document, root);
  read_meshes(document, root);
  read_nodes(document, root);
  read_animations(document, root);
  return document;
}

}  // namespace dermis::scene::gltf
