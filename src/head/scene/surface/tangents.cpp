// SPDX-License-Identifier: MIT
#include "head/scene/surface/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/core/assert.h"
#include "base/core/hooks.h"
#include "head/scene/surface/weld.h"

namespace dermis::scene {
namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Normalises without overflow or underflow; returns zero if that is not possible.
glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  if (!finite(v)) return glm::dvec3(0);
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest < 1e-290) return glm::dvec3(0);
  const glm::dvec3 scaled = v / largest;
  return scaled / glm::length(scaled);
}

bool is_zero(const glm::dvec3& v) { return v == glm::dvec3(0); }

/// The frame of a triangle for [Mik08].
struct TriangleFrame {
  glm::dvec3 dp_du{0};  ///< unit, zero where coordinates are degenerate
  int handedness = 0;   ///< +1 as painted, -1 mirrored, 0 degenerate
};

TriangleFrame triangle_frame(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec2, 3>& t) {
  const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
  const glm::dvec2 d1 = t[1] - t[0], d2 = t[2] - t[0];
  const double det = d1.x * d2.y - d2.x * d1.y;  // twice the signed area in texture space
  // Coordinates are floats: an area smaller than their rounding has a sign without meaning.
  const double magnitude = std::max({glm::length(t[0]), glm::length(t[1]), glm::length(t[2])});
  const double noise =
      std::numeric_limits<float>::epsilon() * magnitude * std::max(glm::length(d1), glm::length(d2));
  if (!std::isfinite(det) || std::abs(det) <= noise) return {};
  // The coordinates of a counter-clockwise triangle run clockwise if v points down and the picture is not
  // mirrored.
  const int handedness = det < 0 ? 1 : -1;
  const glm::dvec3 dp_du = unit_or_zero((d2.y * e1 - d1.y * e2) * (det < 0 ? -1.0 : 1.0));
  return {dp_du, is_zero(dp_du) ? 0 : handedness};
}

double angle_at(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b,
                const glm::dvec3& normal) {
  const auto flat = [&](const glm::dvec3& v) { return unit_or_zero(v - normal * glm::dot(normal, v)); };
  const glm::dvec3 x = flat(a - corner), y = flat(b - corner);
  return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y));
}

/// Returns ids of the vertices that MikkTSpace treats as one: equal position, normal and coordinates, to the
/// bit (only -0 equals 0).
std::vector<std::uint32_t> weld_corners(const std::vector<Vertex>& vertices,
                                        const std::vector<glm::dvec2>& uv) {
  std::vector<glm::dvec3> a, b, c;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    a.emplace_back(vertices[i].position_m);
    b.emplace_back(vertices[i].normal);
    c.emplace_back(uv[i].x, uv[i].y, 0.0);
  }
  const auto position = weld_points(a, 1e-12), normal = weld_points(b, 1e-12),
             coordinate = weld_points(c, 1e-12);
  std::vector<glm::dvec3> ids;
  for (std::size_t i = 0; i < vertices.size(); ++i) ids.emplace_back(position[i], normal[i], coordinate[i]);
  return weld_points(ids, 1.0);
}

/// Appends a copy of a vertex, which comes from where the vertex does.
Vertex& append_copy(Primitive& primitive, std::uint32_t vertex) {
  std::vector<std::uint32_t>& sources = primitive.source_vertices;
  if (sources.empty()) {
    sources.resize(primitive.vertices.size());
    std::iota(sources.begin(), sources.end(), 0u);
  }
  sources.push_back(std::uint32_t{sources[vertex]});
  return primitive.vertices.emplace_back(Vertex(primitive.vertices[vertex]));
}

/// Moves the mirrored corners of vertices that are used both ways to copies, so that every vertex has one
/// handedness.
void split_mirrored(Primitive& primitive, const std::vector<TriangleFrame>& frames) {
  const std::size_t before = primitive.vertices.size();
  std::vector<std::uint8_t> used(before, 0);  // bit 0: as painted, bit 1: mirrored
  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    const int h = frames[i / 3].handedness;
    if (h != 0) used[primitive.indices[i]] |= h > 0 ? 1 : 2;
  }

  std::vector<std::uint32_t> copy(before, 0);
  for (std::uint32_t v = 0; v < before; ++v) {
    if (used[v] == 2) primitive.vertices[v].tangent.w = -1;
    if (used[v] != 3) continue;
    copy[v] = static_cast<std::uint32_t>(primitive.vertices.size());
    append_copy(primitive, v).tangent.w = -1;
  }

  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    std::uint32_t& index = primitive.indices[i];
    if (index < before && used[index] == 3 && frames[i / 3].handedness < 0) index = copy[index];
  }
}

}  // namespace

glm::dvec3 any_tangent(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  return {1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

void make_missing_normals(Primitive& primitive) {
  DERMIS_ASSERT_EQ(primitive.indices.size() % 3, std::size_t{0});
  std::vector<Vertex>& vertices = primitive.vertices;
  std::vector<bool> missing(vertices.size(), false);
  bool any_missing = false;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const glm::dvec3 n = unit_or_zero(glm::dvec3(vertices[v].normal));
    missing[v] = is_zero(n);
    any_missing = any_missing || missing[v];
    vertices[v].normal = glm::vec3(n);
  }
  if (!any_missing) return;

  const std::vector<std::uint32_t> weld = weld_positions(vertices);
  std::vector<glm::dvec3> sum(vertices.size(), glm::dvec3(0));
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    const auto p = [&](std::size_t k) { return glm::dvec3(vertices[primitive.indices[i + k]].position_m); };
    const glm::dvec3 area = glm::cross(p(1) - p(0), p(2) - p(0));  // twice the area along the normal
    if (!finite(area)) continue;
    for (std::size_t k = 0; k < 3; ++k) sum[weld[primitive.indices[i + k]]] += area;
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!missing[v]) continue;
    const glm::dvec3 n = unit_or_zero(sum[weld[v]]);
    vertices[v].normal = is_zero(n) ? glm::vec3(0, 0, 1) : glm::vec3(n);
  }
}

void make_tangents(Primitive& primitive, const glm::mat3x2& normal_map_transform, int uv_set) {
  DERMIS_ASSERT_EQ(primitive.indices.size() % 3, std::size_t{0});
  const glm::dmat3x2 transform(normal_map_transform);
  const auto coordinate = [&](const Vertex& v) {
    return transform * glm::dvec3(uv_set == 1 ? v.uv1 : v.uv0, 1.0);
  };
  for (Vertex& v : primitive.vertices) v.tangent = glm::vec4(0, 0, 0, 1);

  Steps steps("tangents", 3);
  std::vector<TriangleFrame> frames(primitive.indices.size() / 3);
  for (std::size_t t = 0; t < frames.size(); ++t) {
    const auto vertex = [&](std::size_t k) -> const Vertex& {
      return primitive.vertices[primitive.indices[3 * t + k]];
    };
    const auto p = [&](std::size_t k) { return glm::dvec3(vertex(k).position_m); };
    frames[t] = triangle_frame({p(0), p(1), p(2)},
                               {coordinate(vertex(0)), coordinate(vertex(1)), coordinate(vertex(2))});
  }
  split_mirrored(primitive, frames);
  steps.done();

  std::vector<Vertex>& vertices = primitive.vertices;
  std::vector<glm::dvec2> uv;
  for (const Vertex& v : vertices) uv.push_back(coordinate(v));
  const std::vector<std::uint32_t> weld = weld_corners(vertices, uv);
  steps.done();

  // as painted, mirrored
  std::vector<std::array<glm::dvec3, 2>> sum(vertices.size(), {glm::dvec3(0), glm::dvec3(0)});
  for (std::size_t i = 0; i < primitive.indices.size(); ++i) {
    const TriangleFrame& frame = frames[i / 3];
    if (frame.handedness == 0) continue;
    const auto p = [&](std::size_t k) {
      return glm::dvec3(vertices[primitive.indices[i / 3 * 3 + k % 3]].position_m);
    };
    const std::uint32_t v = primitive.indices[i];
    const glm::dvec3 n(vertices[v].normal);
    const glm::dvec3 across = unit_or_zero(frame.dp_du - n * glm::dot(n, frame.dp_du));
    sum[weld[v]][frame.handedness > 0 ? 0 : 1] += across * angle_at(p(i % 3), p(i % 3 + 1), p(i % 3 + 2), n);
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const glm::dvec3 n(vertices[v].normal);
    const glm::dvec3 s = sum[weld[v]][vertices[v].tangent.w > 0 ? 0 : 1];
    // Opposite tangents of equal weight cancel; the remaining rounding has no meaningful direction.
    glm::dvec3 t = glm::length(s) > 1e-9 ? unit_or_zero(s - n * glm::dot(n, s)) : glm::dvec3(0);
    if (is_zero(t)) t = any_tangent(n);
    vertices[v].tangent = glm::vec4(glm::vec3(t), vertices[v].tangent.w);
  }
}

}  // namespace dermis::scene
