// SPDX-License-Identifier: MIT
#include "support.h"

#include <cstring>

#include "base/core/log.h"

namespace dermis::scene::test {

std::optional<fs::path> assets() {
  if (!missing_asset({asset_cache() / "gltf-valid" / "INDEX.tsv"}).empty()) return std::nullopt;
  return fs::canonical(asset_cache());
}

namespace {

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

void append_component(std::string& bytes, float value, int component) {
  switch (component) {
    case 5120: return append(bytes, static_cast<std::int8_t>(value));
    case 5121: return append(bytes, static_cast<std::uint8_t>(value));
    case 5122: return append(bytes, static_cast<std::int16_t>(value));
    case 5123: return append(bytes, static_cast<std::uint16_t>(value));
    case 5125: return append(bytes, static_cast<std::uint32_t>(value));
    default: return append(bytes, value);
  }
}

std::size_t components_of(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "MAT4") return 16;
  return static_cast<std::size_t>(type.back() - '0');
}

}  // namespace

Builder::Builder()
    : json({{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", Json::array()}}}},
            {"nodes", Json::array()},
            {"buffers", Json::array({{{"byteLength", 0}}})}}) {}

int Builder::accessor(const std::vector<float>& values, const std::string& type, int component) {
  const std::size_t start = bytes.size();
  for (const float value : values) append_component(bytes, value, component);
  const std::size_t length = bytes.size() - start;
  while (bytes.size() % 4 != 0) bytes += '\0';
  json["buffers"][0]["byteLength"] = bytes.size();
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", start}, {"byteLength", length}});
  json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                               {"componentType", component},
                               {"count", values.size() / components_of(type)},
                               {"type", type}});
  return static_cast<int>(json["accessors"].size()) - 1;
}

int Builder::mesh(const Json& attributes, int indices) {
  Json primitive = {{"attributes", attributes}};
  if (indices >= 0) primitive["indices"] = indices;
  json["meshes"].push_back({{"primitives", Json::array({primitive})}});
  const int number = static_cast<int>(json["meshes"].size()) - 1;
  json["nodes"].push_back({{"mesh", number}});
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  return number;
}

int Builder::triangle() {
  const int position = accessor({0, 0, 0, 0.2f, 0, 0, 0, 0.2f, 0}, "VEC3");
  const int uv = accessor({0, 0, 1, 0, 0, 1}, "VEC2");
  return mesh({{"POSITION", position}, {"TEXCOORD_0", uv}});
}

std::string Builder::glb() const {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::ignore);
  while (text.size() % 4 != 0) text += ' ';
  std::string out = "glTF";
  append(out, std::uint32_t{2});
  append(out, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + bytes.size()));
  append(out, static_cast<std::uint32_t>(text.size()));
  out += "JSON" + text;
  append(out, static_cast<std::uint32_t>(bytes.size()));
  out += std::string("BIN\0", 4) + bytes;
  return out;
}

fs::path Builder::write(const fs::path& folder, const std::string& name) const {
  write_text(folder / name, glb());
  return folder / name;
}

AssetData Builder::load(const LoadOptions& options) const {
  const TempFolder folder;
  return load_gltf(write(folder.path()), options);
}

std::string Builder::error(const LoadOptions& options) const {
  const TempFolder folder;
  return error_of(write(folder.path()), options);
}

std::string error_of(const fs::path& path, const LoadOptions& options) {
  try {
    load_gltf(path, options);
    return "";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    EXPECT_FALSE(what.empty());
    return what;
  }
}

bool Warnings::any_with(const std::string& part) const { return all().find(part) != std::string::npos; }
std::string Warnings::all() const {
  std::string text;
  for (const std::string& line : said_.all) text += line + "\n";
  return text;
}

}  // namespace dermis::scene::test
