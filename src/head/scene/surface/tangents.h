// SPDX-License-Identifier: MIT
// Makes normals and tangents for meshes that lack them.
// Based on: [Mik08] Mikkelsen: Simulation of Wrinkled Surfaces Revisited. 2008 (the definition that glTF
// names for missing tangents).
#pragma once

#include <glm/glm.hpp>

#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Replaces normals that are zero or not finite by smooth ones: the sum over the triangles at the vertex's
/// position (welded, so that split vertices agree), weighted by area. Degenerate triangles count nothing. A
/// vertex without any area around it gets (0, 0, 1). Normalises all other normals. Afterwards every normal is
/// finite and of unit length.
void make_missing_normals(Primitive& primitive);

/// Replaces all tangents. Needs unit normals (make_missing_normals). Coordinates are those of the normal map:
/// set `uv_set` (0 or 1) through `normal_map_transform` (MapRef::transform), v down.
///
/// [Mik08] per corner: dP/du of the triangle, projected on the plane of the vertex normal, normalised,
/// weighted by the corner's angle, summed over the triangles that share position, normal, coordinates and
/// orientation of the coordinates. w is such that w * cross(normal, tangent) points to the top of the picture
/// (-v), because glTF's normal maps have +Y up and v down. It is +1 where the picture appears as painted, -1
/// where it is mirrored. Vertices between both are split: the mirrored half moves to copies at the end of
/// `vertices`, and indices and `source_vertices` follow. Where coordinates are degenerate the tangent is any
/// unit vector perpendicular to the normal, w = 1. Always finite, unit, orthogonal to the normal.
///
/// Departure: MikkTSpace also splits fans that touch in one vertex but share no edge, and reorders; here they
/// share a tangent.
void make_tangents(Primitive& primitive,
                   const glm::mat3x2& normal_map_transform = glm::mat3x2(1, 0, 0, 1, 0, 0), int uv_set = 0);

/// Returns a unit vector perpendicular to the unit vector n; continuous except at one pole.
/// Based on: [Duf17] Duff et al.: Building an Orthonormal Basis, Revisited. JCGT 2017.
glm::dvec3 any_tangent(const glm::dvec3& n);

}  // namespace dermis::scene
