// SPDX-License-Identifier: MIT
// Transforms the vertices of one node to the world: by the node's matrix, or by the joints of its skin.
#pragma once

#include "head/scene/gltf/mesh.h"

namespace dermis::scene::gltf {

/// The joints' matrices (world from bind pose), computed once per skin for all its nodes.
class JointMatrices {
 public:
  /// Takes `world` from world_matrices. All arguments must outlive this.
  JointMatrices(const Document& document, Bytes& bytes, const std::vector<glm::dmat4>& world)
      : document_(document), bytes_(bytes), world_(world) {}
  /// Returns the matrices of a node's skin, empty if it has none; not finite where the skin's inverse bind
  /// matrix is missing or is not.
  const std::vector<glm::dmat4>& of(int node);

 private:
  const Document& document_;
  Bytes& bytes_;
  const std::vector<glm::dmat4>& world_;
  std::map<int, std::vector<glm::dmat4>> by_skin_;
};

class Frames {
 public:
  /// Takes `joints` from JointMatrices; they must outlive this.
  Frames(const Document& document, const glm::dmat4& node_world, const std::vector<glm::dmat4>& joints);

  /// Takes the weight of joints that the skin does not have; then hangs vertices without weight on their
  /// first joint. Warns of both, and of a mesh that has no joints at all and follows its node. Throws
  /// InputError where vertices hang on a joint whose matrix is not finite.
  void repair_weights(LocalMesh& mesh, const MeshPrimitive& primitive) const;
  const Frame& of_node() const { return rigid_; }  ///< without its skin
  /// Returns the frame of vertex i of a mesh whose weights were repaired.
  Frame at(const LocalMesh& mesh, std::size_t i) const;

 private:
  const Document& document_;
  Frame rigid_;
  const std::vector<glm::dmat4>& joints_;  ///< empty: no skin
};

}  // namespace dermis::scene::gltf
