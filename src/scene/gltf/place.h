// SPDX-License-Identifier: MIT
// The scene at rest: meshes put where their nodes, skins and morph targets have them, as one list of
// world-space primitives.
#pragma once

#include "scene/gltf/mesh.h"
#include "scene/load.h"

namespace dermis::scene::gltf {

/// World matrices of all nodes as they stand, unit scale included.
std::vector<glm::dmat4> world_matrices(const Document& document, double unit_scale);

/// The nodes of the shown scene, parents first.
std::vector<int> shown_nodes(const Document& document);

/// The drawable primitives of the shown scene. Primitive::material is an index into Document::materials, -1 =
/// none. Normals that are missing stay zero; `file_tangents` says of each primitive whether its tangents are
/// the file's and usable. InputError: limits, data, "no triangles to draw".
struct Placed {
  std::vector<Primitive> primitives;
  std::vector<bool> file_tangents;
};
Placed place_meshes(const Document& document, Bytes& bytes, const LoadOptions& options);

}  // namespace dermis::scene::gltf
