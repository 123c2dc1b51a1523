// SPDX-License-Identifier: MIT
// Builds the scene at rest: applies nodes, skins and morph targets to meshes and returns one list of
// primitives. Nodes that share a rigid mesh share its primitives.
#pragma once

#include <array>
#include <map>

#include "head/scene/gltf/mesh.h"
#include "head/scene/import/load_options.h"

namespace dermis::scene::gltf {

/// Returns the world matrices of all nodes, with unit scale.
std::vector<glm::dmat4> world_matrices(const Document& document, double unit_scale);

/// Returns, per node, the number of the first primitive of its mesh: see Primitive::source_mesh.
std::vector<int> first_source_meshes(const Document& document);

/// Returns the nodes of the shown scene, parents first, without those that a hidden one holds.
std::vector<int> shown_nodes(const Document& document);

/// Numbers of the materials that shown primitives use.
struct MaterialNumbers {
  std::map<int, int> of;   ///< index into Document::materials (-1 = none) -> index into AssetData::materials
  std::vector<bool> skin;  ///< by the new number
};

/// A primitive before nodes, joints and morph targets move it.
struct MovingMesh {
  const MeshPrimitive* source = nullptr;  ///< of the document
  LocalMesh local;                        ///< without coordinates and colours
  std::vector<int> nodes;                 ///< one, or those of its placements
  bool placed = false;                    ///< it has placements, and no local mesh
  glm::dvec3 middle{0};                   ///< subtracted from the positions of one with placements
};

/// The drawable primitives of the shown scene; Primitive::material is a new number. A rigid mesh that several
/// nodes share is one primitive with placements, unless it is skin: light spreads by mm, so each node has its
/// own. Missing normals stay zero; `file_tangents` says per primitive whether the tangents of the file are
/// usable, `has_uv` which sets of texture coordinates exist. Throws InputError for faulty data and "no
/// triangles to draw".
struct Placed {
  std::vector<Primitive> primitives;
  std::vector<bool> file_tangents;
  std::vector<std::array<bool, 2>> has_uv;
  std::vector<MovingMesh> moving;  ///< one for each primitive, if they were asked for; else empty
};
Placed place_meshes(const Document& document, Bytes& bytes, const MaterialNumbers& materials,
                    const LoadOptions& options, bool keep_moving);

/// Compares what the file claims with the limits before any of it is read: those of `options`, and the
/// vertices of all copies with the bytes of the file and its buffers, `read_bytes`. Throws InputError if a
/// limit is exceeded or there are no triangles.
void check_limits(const Document& document, std::uint64_t read_bytes, const LoadOptions& options);

/// Throws InputError if there are more nodes of skin with texture coordinates than can be lit separately.
void check_skin_nodes(const Document& document, const MaterialNumbers& materials);

}  // namespace dermis::scene::gltf
