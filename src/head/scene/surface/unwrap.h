// SPDX-License-Identifier: MIT
// The skin of one head on its unwrap: the mesh that texture-space passes draw, its charts, and its metric in
// mm. Based on: [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 5.2
// (stretch); here the full metric, since u and v are not orthogonal on real heads.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// whole numbers up to 2048 are exact in half floats
inline constexpr int max_chart_id = 2046;
/// of triangles that the map does not hold
inline constexpr std::uint16_t no_chart = 0;

/// Where a vertex came from: Primitive::source_mesh and source_vertex().
struct SourceVertex {
  int mesh = 0;
  std::uint32_t vertex = 0;
  bool operator==(const SourceVertex&) const = default;
};

/// The vertex of AssetData::primitives that a vertex was.
struct PrimitiveVertex {
  std::uint32_t primitive = 0, vertex = 0;
};

/// Says which skin shares a mesh, and with it a light map. Skin without texture coordinates has no place on a
/// map, so all of a material is one mesh, from however many nodes.
struct SkinMeshKey {
  int node = -1;      ///< -1: without texture coordinates
  int material = -1;  ///< -1: all of the node that share its map
  auto operator<=>(const SkinMeshKey&) const = default;
};

/// Returns the key of the skin mesh that a primitive of skin belongs to.
inline SkinMeshKey skin_mesh_key(const Primitive& primitive) {
  return {.node = primitive.has_uv ? primitive.node : -1,
          .material = primitive.has_uv && !primitive.own_light_map ? -1 : primitive.material};
}

/// The first triangle of a primitive, among those of its mesh.
struct PrimitiveTriangles {
  std::uint32_t primitive = 0, first_triangle = 0;
};

/// One head. Every vertex belongs to one chart (vertices between charts are split; copies are at the end).
struct SkinMesh {
  std::string name;              ///< of the first primitive, for messages
  SkinMeshKey key;               ///< of all its primitives
  std::vector<Vertex> vertices;  ///< uv0 and uv1 raw
  /// per vertex; vertices that were split have the same
  std::vector<SourceVertex> sources;
  std::vector<PrimitiveVertex> origins;  ///< likewise
  /// triangles in the order of the scene's primitives, so each material is a few runs
  std::vector<std::uint32_t> indices;
  std::vector<int> triangle_material;          ///< per triangle, index into AssetData::materials
  std::vector<PrimitiveTriangles> primitives;  ///< ascending
  /// per vertex, 0..1, v down: position for texture-space passes; (0, 0) for triangles without a chart
  std::vector<glm::vec2> unwrap;
  /// per vertex: g_uu, g_uv, g_vv in mm^2 per unit of unwrap squared; finite, positive definite
  std::vector<glm::vec3> metric;
  /// per triangle, 1 .. max_chart_id; with more charts the ids start again from 1. no_chart: the triangle has
  /// no texture coordinates, none with area, or those of a stray (unwrap_fit.h). It covers nothing of the map
  /// and is lit per pixel.
  std::vector<std::uint16_t> triangle_chart;
  int charts = 0;  ///< number of charts
  /// Parts of the map on which charts that overlap lie side by side: see lay_charts_apart().
  int layers = 1;
  /// unwrap = uv0 * scale + offset for triangles with a chart: see fit_unwrap(). Of several layers each has
  /// an offset of its own, and this one means nothing.
  glm::dvec2 unwrap_scale{1}, unwrap_offset{0};
  /// changes of fit_unwrap() to the raw coordinates; empty: none
  std::string unwrap_note;
};

/// Returns one mesh per key, in order of first appearance, all its skin primitives joined.
/// Fits raw coordinates into 0..1 where needed; triangles that cannot lie there have no chart, see
/// fit_unwrap(). Skips primitives without triangles. Metric: see triangle_metric.
std::vector<SkinMesh> skin_meshes(const AssetData& scene);

/// Returns whether a triangle of the mesh has no chart.
bool has_chartless(const SkinMesh& mesh);

/// Returns, for each vertex, the triangles whose metrics compute_metric() averages there, whatever the shape
/// of the mesh. Packed as turned_neighbours(): the entries of vertex v are [packed[v], packed[v + 1]) of
/// `packed` itself. Without triangles that are left out as the mesh is now.
std::vector<std::uint32_t> metric_triangles(const SkinMesh& mesh, double mm_per_unit);

/// Returns g = J^T J with J = dP/d(u,v) in mm: (g_uu, g_uv, g_vv). Zero if the triangle has no area in
/// texture space or in the world.
glm::dvec3 triangle_metric(const glm::dvec3& a_mm, const glm::dvec3& b_mm, const glm::dvec3& c_mm,
                           const glm::vec2& uv_a, const glm::vec2& uv_b, const glm::vec2& uv_c);

/// Fills mesh.metric from positions and unwrap: averages triangle metrics at each vertex, weighted by area in
/// texture space, within a chart only. Leaves out triangles stretched beyond 1/1000 .. 32 times the mesh's
/// median length scale; vertices without any other get the mean of the mesh. Limits the ratio of lengths to
/// 300, so that floats hold the determinant.
void compute_metric(SkinMesh& mesh, double mm_per_unit);

/// Returns (a, b, c) with g^-1 = L L^T, L = [[a, 0], [b, c]]: the image of one isotropic mm in texture
/// coordinates, as two successive directions: (a, b) slanted, then (0, c) along v. g must be positive
/// definite.
glm::dvec3 inverse_metric_cholesky(const glm::dvec3& g);

/// Statistics over the skin's area, weighted by mm^2.
struct DensityStats {
  double mean = 0, p05 = 0, p25 = 0, p50 = 0, p95 = 0, max = 0;
};

struct UnwrapDensity {
  /// texture coordinates (0..1) per mm, times the side of a map: its texels per mm. Geometric mean of both
  /// directions, det(g)^(-1/4)
  DensityStats uv_per_mm;
  DensityStats largest_uv_per_mm;  ///< in the densest direction, 1 / sqrt(smallest eigenvalue of g)
  DensityStats least_uv_per_mm;    ///< in the coarsest direction, 1 / sqrt(largest eigenvalue of g)
  double area_mm2 = 0;             ///< all triangles
};

/// Returns the density of the triangles themselves, not of the averaged metric. All zero for a mesh without
/// valid triangles.
UnwrapDensity unwrap_density(const SkinMesh& mesh, double mm_per_unit);

}  // namespace dermis::scene
