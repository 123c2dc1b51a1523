// SPDX-License-Identifier: MIT
#include "scene/gltf/document.h"

#include <algorithm>
#include <cctype>

#include "core/log.h"

namespace dermis::scene::gltf {

namespace {

/// Extensions that a file may require. (Required or not, each is read wherever it occurs.)
constexpr std::array<std::string_view, 9> supported_extensions{
    "EXT_meshopt_compression", "KHR_draco_mesh_compression",
    "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_ior",       "KHR_materials_specular",
    "KHR_materials_unlit",     "KHR_mesh_quantization",
    "KHR_texture_transform"};

struct Version {
  int major = 0, minor = 0;
};

Version read_version(const Value& value) {
  const std::string& text = value.text();
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
  std::vector<std::string> names(list->array_size());
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = list->element(i).text();
  return names;
}

/// Checks what all objects have in common: `name` is a string, `extensions` holds objects.
void check_common(const Value& object) {
  if (const auto name = object.find("name")) name->text();
  const auto extensions = object.find("extensions");
  if (!extensions) return;
  for (const std::string& key : extensions->keys()) extensions->at(key).object();
}

// What `{}` stands for takes half a kilobyte as a node, and over one as a material.
void check_sizes(const Value& root) {
  constexpr std::pair<const char*, std::size_t> limits[] = {{"nodes", 1'000'000}, {"materials", 65'536}};
  for (const auto& [collection, most] : limits)
    if (const auto list = root.find(collection); list && list->is_array() && list->array_size(0) > most)
      list->fail("has {} elements, the limit is {}", list->array_size(0), most);
}

void check_collections(const Value& root) {
  check_common(root);
  check_sizes(root);
  for (const char* collection : {"accessors", "animations", "buffers", "bufferViews", "cameras", "images",
                                 "materials", "meshes", "nodes", "samplers", "scenes", "skins", "textures"})
    root.for_each(collection, check_common);
}

}  // namespace

void read_header(Document& document, const Value& root) {
  const Value asset = root.at("asset").object();
  const Value version_value = asset.at("version");
  const Version version = read_version(version_value);
  if (version.major != 2)
    version_value.fail("glTF {}.{} is not supported, expected 2.0", version.major, version.minor);

  if (const std::optional<Value> least = asset.find("minVersion")) {
    const Version minimum = read_version(*least);
    if (minimum.major != 2 || minimum.minor != 0)
      least->fail("needs glTF {}.{}, this reader knows 2.0", minimum.major, minimum.minor);
  }
  if (version.minor != 0) warn("{}: glTF 2.{} is read as 2.0", document.file, version.minor);

  const auto is_supported = [](const std::string& name) {
    return std::find(supported_extensions.begin(), supported_extensions.end(), name) !=
           supported_extensions.end();
  };
  for (const std::string& name : names_in(root, "extensionsRequired"))
    if (!is_supported(name))
      throw input_error(document.file, "requires the extension {}, which is not supported; supported are: {}",
                        name, fmt::join(supported_extensions, ", "));

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
  check_collections(root);
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
