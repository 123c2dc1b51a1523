// SPDX-License-Identifier: MIT
// Makes the skin of a head as a mesh on its unwrap, and its metric in mm. Based on: [DLE07] d'Eon, Luebke,
// Enderton: Efficient Rendering of Human Skin. EGSR 2007, sec. 5.2 (stretch); here the full metric, since u
// and v are not orthogonal on real heads.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/skin_mesh.h"

namespace dermis::scene {

/// Returns the key of the skin mesh that a primitive of skin belongs to.
inline SkinMeshKey skin_mesh_key(const Primitive& primitive) {
  return {.node = primitive.has_uv ? primitive.node : -1,
          .material = primitive.has_uv && !primitive.own_light_map ? -1 : primitive.material};
}

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

/// Returns the density of the triangles themselves, not of the averaged metric. All zero for a mesh without
/// valid triangles.
UnwrapDensity unwrap_density(const SkinMesh& mesh, double mm_per_unit);

}  // namespace dermis::scene
