// SPDX-License-Identifier: MIT
// The scene at rest: meshes put where their nodes, skins and morph targets have them, as one list of
// primitives. Nodes that share a rigid mesh share its primitives.
#pragma once

#include <array>
#include <map>

#include "scene/gltf/mesh.h"
#include "scene/load.h"

namespace dermis::scene::gltf {

/// World matrices of all nodes as they stand, unit scale included.
std::vector<glm::dmat4> world_matrices(const Document& document, double unit_scale);

/// The nodes of the shown scene, parents first.
std::vector<int> shown_nodes(const Document& document);

/// Materials of the document that shown primitives use, renumbered.
struct MaterialNumbers {
  std::map<int, int> of;   ///< index into Document::materials (-1 = none) -> index into Scene::materials
  std::vector<bool> skin;  ///< by the new number
};

/// The drawable primitives of the shown scene; Primitive::material is a new number. A rigid mesh that several
/// nodes share becomes one primitive with placements, unless it is skin: light spreads by mm, so each node
/// has its own. Normals that are missing stay zero; `file_tangents` says of each primitive whether its
/// tangents are the file's and usable, `has_uv` which sets of texture coordinates it has. InputError: data,
/// "no triangles to draw".
struct Placed {
  std::vector<Primitive> primitives;
  std::vector<bool> file_tangents;
  std::vector<std::array<bool, 2>> has_uv;
};
Placed place_meshes(const Document& document, Bytes& bytes, const MaterialNumbers& materials,
                    const LoadOptions& options);

/// Holds what the file claims against the limits, before any of it is read. InputError: over a limit, or no
/// triangles.
void check_limits(const Document& document, const LoadOptions& options);

/// InputError: more nodes of skin with texture coordinates than can be lit, each by itself.
void check_skin_nodes(const Document& document, const MaterialNumbers& materials);

}  // namespace dermis::scene::gltf
