// SPDX-License-Identifier: MIT
#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "base/core/error.h"
#include "head/scene/arrays/check.h"
#include "head/scene/import/limits.h"
#include "head/scene/surface/local_mesh.h"

namespace dermis::scene::arrays {

namespace {

constexpr int largest_node = 1'000'000;

template <std::size_t N>
std::span<const float> flat(std::span<const std::array<float, N>> values) {
  return {values.empty() ? nullptr : values.front().data(), values.size() * N};
}

/// Attributes are absent, or there is one of each vertex.
void check_counts(const std::string& where, const AssetMesh& mesh) {
  const std::size_t vertices = mesh.positions_m.size();
  const auto check = [&](const char* member, std::size_t count) {
    if (count != 0 && count != vertices)
      throw input_error(where, "{} has {} elements, positions_m has {}", member, count, vertices);
  };
  check("normals", mesh.normals.size());
  check("tangents", mesh.tangents.size());
  check("uv0", mesh.uv0.size());
  check("uv1", mesh.uv1.size());
  check("colours", mesh.colours.size());

  const std::size_t corners = mesh.indices.empty() ? vertices : mesh.indices.size();
  const char* member = mesh.indices.empty() ? "positions_m" : "indices";
  if (corners == 0) throw input_error(where, "has no triangles: positions_m is empty");
  if (corners % 3 != 0)
    throw input_error(where, "{} has {} elements, expected three per triangle", member, corners);
}

void check_numbers(const MeshPlace& place, const AssetMesh& mesh, double unit_scale) {
  check_indices(place, mesh.indices, mesh.positions_m.size());
  check_finite(place, "positions_m", flat(mesh.positions_m), 3);
  check_finite(place, "uv0", flat(mesh.uv0), 2);
  check_finite(place, "uv1", flat(mesh.uv1), 2);
  check_finite(place, "colours", flat(mesh.colours), 4);

  for (std::size_t i = 0; i < mesh.positions_m.size(); ++i) {
    const auto& [x, y, z] = mesh.positions_m[i];
    check_position(place, glm::vec3(unit_scale * glm::dvec3(x, y, z)), i);
  }
  for (const auto& uvs : {mesh.uv0, mesh.uv1})
    for (std::size_t i = 0; i < uvs.size(); ++i) check_coordinates(place, {uvs[i][0], uvs[i][1]}, i);
}

void check_references(const std::string& where, const AssetMesh& mesh, std::size_t materials) {
  if (mesh.material < -1 || mesh.material >= static_cast<std::int64_t>(materials))
    throw input_error(where, "material is {}, there are {} materials (-1 for none)", mesh.material,
                      materials);
  if (mesh.node < -1 || mesh.node > largest_node)
    throw input_error(where, "node must be -1 to {}, got {}", largest_node, mesh.node);
}

}  // namespace

std::size_t triangles_of(const AssetMesh& mesh) {
  return (mesh.indices.empty() ? mesh.positions_m.size() : mesh.indices.size()) / 3;
}

void check_meshes(const AssetArrays& arrays, const LoadOptions& options) {
  const std::string name = name_of(arrays);
  if (arrays.meshes.empty()) throw input_error(name, "there are no triangles to draw");

  // Counts come first: they are cheap, and bound the rest.
  const std::size_t max_vertices = options.max_triangles * 3;
  std::size_t triangles = 0, vertices = 0;
  for (std::size_t i = 0; i < arrays.meshes.size(); ++i) {
    const AssetMesh& mesh = arrays.meshes[i];
    const std::string where = name + ": " + place_of("mesh", i, mesh.name);
    check_references(where, mesh, arrays.materials.size());
    check_counts(where, mesh);
    triangles += triangles_of(mesh);
    vertices += mesh.positions_m.size();
    if (triangles > options.max_triangles)
      throw input_error(name, "has more than {} triangles, the limit", options.max_triangles);
    if (vertices > max_vertices)
      throw input_error(name, "has more than {} vertices, the limit", max_vertices);
  }

  for (std::size_t i = 0; i < arrays.meshes.size(); ++i) {
    const std::string place = place_of("mesh", i, arrays.meshes[i].name);
    check_numbers({name, place}, arrays.meshes[i], options.unit_scale);
  }
}

}  // namespace dermis::scene::arrays
