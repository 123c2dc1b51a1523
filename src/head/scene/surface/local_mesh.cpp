// SPDX-License-Identifier: MIT
#include "head/scene/surface/local_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/core/error.h"
#include "head/scene/import/limits.h"

namespace dermis::scene {

namespace {

/// Normalises; returns zero if there is no direction, which make_missing_normals fills in.
glm::vec3 float_unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-30 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0);
}

glm::dvec3 vec3_at(const std::vector<float>& values, std::size_t i, int components) {
  return {values[i * components], values[i * components + 1], values[i * components + 2]};
}

}  // namespace

Frame frame_of(const glm::dmat4& matrix) {
  // Cofactors are |M| M^-T without division by |M|. Its sign is removed, so that normals keep pointing
  // outwards under a mirror.
  const glm::dvec3 x(matrix[0]), y(matrix[1]), z(matrix[2]);
  const glm::dmat3 cofactors(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  const bool mirrored = glm::dot(x, cofactors[0]) < 0;
  return {matrix, mirrored ? -cofactors : cofactors, mirrored};
}

void check_indices(const MeshPlace& place, std::span<const std::uint32_t> indices, std::size_t vertices) {
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= vertices)
      throw input_error(std::string(place.file), "{}: index {} is {}, there are {} vertices", place.mesh, i,
                        indices[i], vertices);
}

void check_finite(const MeshPlace& place, std::string_view name, std::span<const float> values,
                  int components) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw input_error(std::string(place.file), "{}: {} of vertex {} is not finite", place.mesh, name,
                        i / static_cast<std::size_t>(components));
}

void check_position(const MeshPlace& place, const glm::vec3& position_m, std::size_t i) {
  const glm::vec3 p = glm::abs(position_m);
  if (!(p.x <= largest_position_m && p.y <= largest_position_m && p.z <= largest_position_m))
    throw input_error(std::string(place.file),
                      "{}: vertex {} lies at ({}, {}, {}) m, more than {} m from the origin", place.mesh, i,
                      position_m.x, position_m.y, position_m.z, largest_position_m);
}

void check_coordinates(const MeshPlace& place, const glm::vec2& uv, std::size_t i) {
  if (std::abs(uv.x) > largest_uv || std::abs(uv.y) > largest_uv)
    throw input_error(std::string(place.file),
                      "{}: texture coordinates ({}, {}) of vertex {} are out of range", place.mesh, uv.x,
                      uv.y, i);
}

std::vector<std::uint32_t> drop_unused(std::vector<std::uint32_t>& indices, std::size_t vertices) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(vertices, unused);
  for (const std::uint32_t i : indices) number[i] = 0;

  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < vertices; ++i) {
    if (number[i] == unused) continue;
    number[i] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(static_cast<std::uint32_t>(i));
  }
  if (kept.size() == vertices) return {};

  for (std::uint32_t& i : indices) i = number[i];
  return kept;
}

Vertex place_vertex(const LocalMesh& mesh, std::size_t i, const Frame& frame) {
  Vertex v;
  v.position_m = glm::vec3(frame.matrix * glm::dvec4(vec3_at(mesh.positions, i, 3), 1));
  v.normal = mesh.normals.empty() ? glm::vec3(0)
                                  : float_unit_or_zero(frame.normal_matrix * vec3_at(mesh.normals, i, 3));
  if (!mesh.tangents.empty()) {
    const glm::dvec3 n(v.normal), t = glm::dmat3(frame.matrix) * vec3_at(mesh.tangents, i, 4);
    const float w = mesh.tangents[i * 4 + 3] < 0 ? -1.0f : 1.0f;
    v.tangent = glm::vec4(float_unit_or_zero(t - n * glm::dot(n, t)), frame.mirrored ? -w : w);
  }
  if (!mesh.uvs[0].empty()) v.uv0 = {mesh.uvs[0][i * 2], mesh.uvs[0][i * 2 + 1]};
  if (!mesh.uvs[1].empty()) v.uv1 = {mesh.uvs[1][i * 2], mesh.uvs[1][i * 2 + 1]};
  for (int c = 0; c < 4 && !mesh.colours.empty(); ++c)
    v.colour[c] = std::clamp(mesh.colours[i * 4 + c], 0.0f, 1.0f);
  return v;
}

bool usable_tangents(const LocalMesh& mesh, const std::vector<Vertex>& placed) {
  if (mesh.tangents.empty() || mesh.normals.empty()) return false;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const bool has_sign = std::abs(std::abs(mesh.tangents[i * 4 + 3]) - 1) < 0.01f;
    if (!has_sign || placed[i].normal == glm::vec3(0) || glm::vec3(placed[i].tangent) == glm::vec3(0))
      return false;
  }
  return true;
}

}  // namespace dermis::scene
