// SPDX-License-Identifier: MIT
/// Parts that an asset keeps to be posed again without its file: nodes, skins, morph targets, clips, and its
/// vertices before any of these moved them. Source: glTF 2.0 specification, sections 3.5, 3.7.2.2, 3.7.3.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/framing.h"
#include "head/scene/rig/animation.h"

namespace dermis::scene {

struct RigNode {
  std::string name;                  ///< empty: the file has none
  int parent = -1;                   ///< its number is lower or higher; never a loop
  std::optional<glm::dmat4> matrix;  ///< in place of a transform; such a node cannot be moved
  std::vector<std::string> weights;  ///< names of the morph targets of its mesh; empty where unnamed
};

/// A matrix that vertices hang on: node to world, after `bind`.
struct RigMatrix {
  int node = 0;
  glm::dmat4 bind{1};  ///< inverse bind matrix of a joint
};

/// A vertex hangs on a matrix.
struct Influence {
  std::uint32_t matrix = 0;  ///< number in Rig::matrices
  float weight = 1;          ///< those of a vertex sum to 1
};

/// Shift of a vertex by a morph target, at weight 1.
struct MorphDelta {
  std::uint32_t weight = 0;  ///< number in PosedRig::weights
  glm::vec3 position{0}, normal{0}, tangent{0};
};

/// Shift of the vertices of a matrix by a morph target, at weight 1, in the mesh's coordinates.
struct MorphReach {
  std::uint32_t weight = 0;
  glm::vec3 low{0}, high{0};  ///< of all vertices, also of those that it leaves where they are
};

/// Bounds of the vertices of a matrix, in the mesh's coordinates.
struct RigBounds {
  std::uint32_t matrix = 0;
  bool skin = false;  ///< of skin; else of all else
  glm::vec3 low{0}, high{0};
  std::vector<MorphReach> reach;
};

/// Of one primitive of the scene: its vertices in the mesh's own coordinates. Per vertex of the source, which
/// several of the primitive's may share.
struct RigMesh {
  std::vector<std::uint32_t> source;  ///< per vertex of the primitive; empty: the same numbers
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec3> tangents;  ///< per vertex of the primitive, of any length
  /// Where the lists of a vertex begin, and one more.
  std::vector<std::uint32_t> first_influence, first_delta;
  std::vector<Influence> influences;
  std::vector<MorphDelta> deltas;  ///< only those that are not zero
  /// Of a primitive with placements: the matrix of each. Their vertices stay, and the rest is empty.
  std::vector<std::uint32_t> placed;
  glm::dvec3 middle{0};  ///< subtracted from positions of placed ones

  std::uint32_t source_of(std::size_t vertex) const {
    return source.empty() ? static_cast<std::uint32_t>(vertex) : source[vertex];
  }
};

struct RigClip {
  Clip clip;
  std::string error;  ///< why it cannot be played, one line; empty: it can
};

struct Rig {
  double unit_scale = 1;
  std::vector<RigNode> nodes;
  std::vector<int> order;  ///< of the nodes, parents first
  Pose rest;               ///< in which the asset was loaded
  std::vector<RigMatrix> matrices;
  std::vector<std::uint32_t> first_weight;  ///< by node, number of its first morph weight; and one more
  std::vector<RigClip> clips;
  std::vector<RigMesh> meshes;                 ///< one for each of AssetData::primitives
  std::vector<RigBounds> bounds;               ///< of all meshes
  std::vector<int> camera_nodes, light_nodes;  ///< at which those of the scene stand, in their order
};

/// A pose as vertices need it.
struct PosedRig {
  std::vector<glm::dmat4> matrices;  ///< world from mesh, one for each of Rig::matrices
  std::vector<double> weights;       ///< of all morph targets of all nodes
  std::vector<glm::dmat4> cameras,
      lights;  ///< world from the node of each, by Rig::camera_nodes, light_nodes
};

/// Throws InputError (`file` names the asset): a matrix is not finite.
PosedRig posed(const Rig& rig, const Pose& pose, const std::string& file);

/// Moves vertices, placements, cameras and lights of the scene that the rig belongs to. Texture coordinates,
/// colours, handedness and winding stay.
void take_pose(const Rig& rig, const PosedRig& pose, AssetData& scene);

/// Returns where a vertex of the scene that the rig belongs to stands in a pose, m. Of a primitive with
/// placements: at the first one.
glm::dvec3 posed_position_m(const AssetData& scene, const PosedRig& pose, std::size_t primitive,
                            std::size_t vertex);

/// Returns a box and a sphere that hold all vertices of the skin in a pose, or of everything (`all`); not the
/// smallest. Does not read vertices. Nothing: a radius of 0.
Bounds posed_bounds(const Rig& rig, const PosedRig& pose, bool all);

/// Returns points whose convex hull holds all vertices in a pose. Does not read vertices.
std::vector<glm::vec3> posed_corners(const Rig& rig, const PosedRig& pose);

/// Fills Rig::bounds from its meshes. `skin`: by mesh.
void fill_bounds(Rig& rig, const std::vector<bool>& skin);

}  // namespace dermis::scene
