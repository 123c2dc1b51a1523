// SPDX-License-Identifier: MIT
// The skin of one head on its unwrap: the mesh that texture-space passes draw, its charts, and its metric in
// mm. surface/unwrap.h makes it.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace dermis::scene {

/// One corner of a triangle. Texture coordinates are raw (no KHR_texture_transform), v down as in glTF.
struct Vertex {
  glm::vec3 position_m{0};
  glm::vec3 normal{0, 0, 1};  ///< unit
  /// unit xyz, w = handedness (+1 or -1); for the normal map's transformed coordinates
  glm::vec4 tangent{1, 0, 0, 1};
  glm::vec2 uv0{0};
  glm::vec2 uv1{0};
  glm::vec4 colour{1};  ///< COLOR_0, linear; 1 if absent
};

/// whole numbers up to 2048 are exact in half floats
inline constexpr int max_chart_id = 2046;
/// of triangles that the map does not hold
inline constexpr std::uint16_t no_chart = 0;

/// The source of a vertex: Primitive::source_mesh and source_vertex().
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
  UnwrapDensity density;  ///< filled by measured()
  double overlap = 0;     ///< uv_overlap_fraction(), likewise
};

}  // namespace dermis::scene
