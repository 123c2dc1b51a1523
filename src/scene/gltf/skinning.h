// SPDX-License-Identifier: MIT
// How the vertices of one node get into the world: by the node's matrix, or by its skin's joints as they
// stand.
#pragma once

#include "scene/gltf/mesh.h"

namespace dermis::scene::gltf {

struct Frame {
  glm::dmat4 matrix{1};
  /// inverse transpose up to a positive factor; sound for flat (singular) matrices too
  glm::dmat3 normal_matrix{1};
  bool mirrored = false;
};

/// The joints' matrices (world from bind pose), computed once a skin however many nodes hang on it.
class JointMatrices {
 public:
  /// `world` as of world_matrices. All arguments must outlive this.
  JointMatrices(const Document& document, Bytes& bytes, const std::vector<glm::dmat4>& world)
      : document_(document), bytes_(bytes), world_(world) {}
  /// Of a node's skin, empty if it has none. InputError: an inverse bind matrix that is not finite.
  const std::vector<glm::dmat4>& of(int node);

 private:
  const Document& document_;
  Bytes& bytes_;
  const std::vector<glm::dmat4>& world_;
  std::map<int, std::vector<glm::dmat4>> by_skin_;
};

class Frames {
 public:
  /// `joints` of JointMatrices; must outlive this.
  Frames(const Document& document, const glm::dmat4& node_world, const std::vector<glm::dmat4>& joints);

  /// InputError: a joint number beyond the skin's joints.
  void check_joints(const LocalMesh& mesh, const MeshPrimitive& primitive) const;
  const Frame& of_node() const { return rigid_; }  ///< without its skin
  /// Of vertex i of a mesh whose joints were checked.
  Frame at(const LocalMesh& mesh, std::size_t i) const;

 private:
  const Document& document_;
  Frame rigid_;
  const std::vector<glm::dmat4>& joints_;  ///< empty: no skin
};

}  // namespace dermis::scene::gltf
