// SPDX-License-Identifier: MIT
// Reads one primitive of a mesh, before nodes, skins and morph targets are applied.
#pragma once

#include "head/scene/gltf/bytes.h"
#include "head/scene/surface/local_mesh.h"

namespace dermis::scene::gltf {

/// Return the triangles and vertices that a primitive claims; 0 triangles for points and lines.
std::uint64_t claimed_triangles(const Document& document, const MeshPrimitive& primitive);
std::uint64_t claimed_vertices(const Document& document, const MeshPrimitive& primitive);

/// Throws InputError for indices out of range, positions that are not finite, damaged Draco data.
LocalMesh read_mesh(const Document& document, Bytes& bytes, const MeshPrimitive& primitive);

/// Returns the elements named by `order`, `components` numbers each; an empty order keeps all.
std::vector<float> gather(std::vector<float> values, int components, const std::vector<std::uint32_t>& order);

struct DracoMesh {
  std::size_t vertices = 0;
  std::vector<std::uint32_t> indices;
  std::map<std::string, std::vector<float>> attributes;
};
/// Decodes KHR_draco_mesh_compression. Throws InputError if the data is damaged or differs from the
/// primitive's accessors.
DracoMesh decode_draco(const Document& document, Bytes& bytes, const MeshPrimitive& primitive);

}  // namespace dermis::scene::gltf
