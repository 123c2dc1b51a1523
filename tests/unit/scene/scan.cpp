// SPDX-License-Identifier: MIT
#include "scan.h"

#include <cstring>
#include <filesystem>
#include <span>

#include "base/core/file.h"
#include "head/scene/surface/tangents.h"
#include "support/assets.h"

namespace dermis::scene::test {
namespace {

constexpr std::size_t binary_chunk = 1944;  // byte offset in the file
constexpr std::size_t vertex_count = 9279, index_count = 53052;
constexpr double metres_per_unit = 0.0530;

template <class T>
T value_at(std::span<const std::byte> bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.subspan(offset, sizeof(T)).data(), sizeof(T));
  return value;
}

}  // namespace

std::optional<AssetData> load_scan() {
  const std::filesystem::path path = tests::asset_cache() / "lee-perry-smith" / "LeePerrySmith.glb";
  if (!std::filesystem::exists(path)) return std::nullopt;

  const std::vector<std::byte> file = read_file(path);
  const std::span<const std::byte> bytes = std::span(file).subspan(binary_chunk);

  Primitive primitive;
  primitive.name = "scan";
  primitive.node = 0;
  primitive.has_uv = true;
  for (std::size_t i = 0; i < index_count; ++i)
    primitive.indices.push_back(value_at<std::uint16_t>(bytes, 2 * i));
  for (std::size_t i = 0; i < vertex_count; ++i) {
    Vertex vertex;
    vertex.position_m = glm::vec3(glm::dvec3(value_at<glm::vec3>(bytes, 106104 + 12 * i)) * metres_per_unit);
    vertex.normal = value_at<glm::vec3>(bytes, 217452 + 12 * i);
    vertex.uv0 = value_at<glm::vec2>(bytes, 328800 + 8 * i);
    primitive.vertices.push_back(vertex);
  }

  make_missing_normals(primitive);
  make_tangents(primitive, glm::mat3x2(1, 0, 0, -1, 0, 1));

  AssetData scene;
  scene.name = "scan";
  scene.materials.push_back(material("skin", true));
  scene.primitives.push_back(std::move(primitive));
  return scene;
}

Material material(const std::string& name, bool skin) {
  Material made;
  made.name = name;
  made.skin = skin;
  return made;
}

}  // namespace dermis::scene::test
