// SPDX-License-Identifier: MIT
#include "head/builtin_head/parts.h"

#include "head/scene/surface/tangents.h"

namespace dermis::builtin_head {

int add_openness(scene::AssetData& scene, const char* name, float share) {
  constexpr int side = 4;
  const auto byte = static_cast<std::uint8_t>(255.0f * share + 0.5f);
  image::Image8 map{.width = side, .height = side, .rgba = {}};
  map.rgba.assign(static_cast<std::size_t>(side) * side * 4, byte);
  scene.images.push_back({name, std::make_shared<const image::Image8>(std::move(map))});
  return static_cast<int>(scene.images.size()) - 1;
}

PartMesh::PartMesh(const char* name, int material) {
  mesh_.name = name;
  mesh_.material = material;
  mesh_.node = 0;
  mesh_.has_uv = true;
}

std::uint32_t PartMesh::add(const vec3& symmetric_mm, const vec3& normal, const vec2& uv) {
  scene::Vertex v;
  v.position_m = to_world_m(from_symmetric(symmetric_mm));
  v.normal = glm::normalize(normal);
  v.uv0 = v.uv1 = uv;
  mesh_.vertices.push_back(v);
  return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
}

void PartMesh::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
}

void PartMesh::grid(std::uint32_t first, int columns, int rows, bool turned) {
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const auto at = [&](int k, int l) {
        return first + static_cast<std::uint32_t>((j + l) * columns + i + k);
      };
      if (turned) {
        triangle(at(0, 0), at(1, 1), at(1, 0)), triangle(at(0, 0), at(0, 1), at(1, 1));
      } else {
        triangle(at(0, 0), at(1, 0), at(1, 1)), triangle(at(0, 0), at(1, 1), at(0, 1));
      }
    }
  }
}

scene::Primitive PartMesh::finish() {
  scene::make_tangents(mesh_, scene::MapRef{}.transform, 0);
  return std::move(mesh_);
}

}  // namespace dermis::builtin_head
