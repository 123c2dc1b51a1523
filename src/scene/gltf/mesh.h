// SPDX-License-Identifier: MIT
// One primitive of a mesh in its own coordinates: triangles and attributes as float arrays, before nodes,
// skins and morph targets are applied.
#pragma once

#include "scene/gltf/bytes.h"

namespace dermis::scene::gltf {

/// Arrays hold `vertices` times their number of components; an absent attribute is empty. Every index is
/// below `vertices`, every vertex is used, and all numbers but normals and tangents are finite.
struct LocalMesh {
  std::size_t vertices = 0;
  std::vector<std::uint32_t> indices;  ///< triangles
  /// element of the accessors of each vertex; empty: the same index
  std::vector<std::uint32_t> original;
  std::vector<float> positions, normals, tangents;    ///< 3, 3, 4 each
  std::array<std::vector<float>, 2> uvs;              ///< 2 each
  std::vector<float> colours;                         ///< 4 each
  std::array<std::vector<float>, 2> joints, weights;  ///< 4 each
};

/// Return the triangles and vertices that a primitive claims; 0 triangles for points and lines.
std::uint64_t claimed_triangles(const Document& document, const MeshPrimitive& primitive);
std::uint64_t claimed_vertices(const Document& document, const MeshPrimitive& primitive);

/// Throws InputError for indices out of range, numbers that are not finite, damaged Draco data.
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
