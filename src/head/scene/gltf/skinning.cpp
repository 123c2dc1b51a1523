// SPDX-License-Identifier: MIT
#include "head/scene/gltf/skinning.h"

#include <cmath>

#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {

namespace {

constexpr double least_weight = 1e-6;

double sum_of_weights(const LocalMesh& mesh, std::size_t vertex) {
  double sum = 0;
  for (const std::vector<float>& weights : mesh.weights)
    for (std::size_t k = 4 * vertex; k < 4 * vertex + 4 && k < weights.size(); ++k) sum += weights[k];
  return sum;
}

bool is_finite(const glm::dmat4& m) {
  for (glm::length_t k = 0; k < 16; ++k)
    if (!std::isfinite(m[k / 4][k % 4])) return false;
  return true;
}

}  // namespace

const std::vector<glm::dmat4>& JointMatrices::of(int node) {
  const int number = document_.nodes[node].skin;
  const auto [entry, is_new] = by_skin_.try_emplace(number);
  if (number < 0 || !is_new) return entry->second;
  const Skin& skin = document_.skins[number];
  check_fault(skin.fault);
  const std::vector<float> inverse_bind =
      skin.inverse_bind >= 0 ? bytes_.floats(skin.inverse_bind) : std::vector<float>{};
  for (std::size_t j = 0; j < skin.joints.size(); ++j) {
    glm::dmat4 bind(1);
    for (std::size_t k = 0; k < 16 && !inverse_bind.empty(); ++k)
      bind[static_cast<glm::length_t>(k / 4)][static_cast<glm::length_t>(k % 4)] =
          16 * j + k < inverse_bind.size() ? double{inverse_bind[16 * j + k]} : NAN;
    const int joint = skin.joints[j];
    entry->second.push_back(joint < 0 ? glm::dmat4(NAN) : world_[static_cast<std::size_t>(joint)] * bind);
  }
  return entry->second;
}

Frames::Frames(const Document& document, const glm::dmat4& node_world, const std::vector<glm::dmat4>& joints)
    : document_(document), rigid_(frame_of(node_world)), joints_(joints) {}

void Frames::repair_weights(LocalMesh& mesh, const MeshPrimitive& primitive) const {
  if (joints_.empty()) return;
  check_fault(primitive.joints_fault);
  if (mesh.joints[0].empty() && mesh.joints[1].empty())
    return warn_at(document_.file, primitive.place,
                   "has no joints, though its node has a skin: it follows the node");

  const auto most = static_cast<float>(joints_.size());
  const auto is_there = [&](float joint) { return joint >= 0 && joint < most; };
  bool beyond = false;
  for (std::size_t set = 0; set < 2; ++set)
    for (std::size_t i = 0; i < mesh.joints[set].size(); ++i) {
      if (mesh.weights[set][i] == 0 || is_there(mesh.joints[set][i])) continue;
      mesh.weights[set][i] = 0;
      beyond = true;
    }
  if (beyond)
    warn_at(document_.file, primitive.place, "has vertices that hang on joints which the skin does not have");

  // As other viewers do. The node of a skinned mesh may stand anywhere, in any unit.
  bool loose = false;
  const std::size_t first = mesh.joints[0].empty() ? 1 : 0;
  for (std::size_t i = 0; i < mesh.vertices; ++i) {
    if (sum_of_weights(mesh, i) > least_weight) continue;
    float& joint = mesh.joints[first][4 * i];
    if (!is_there(joint)) joint = 0;
    mesh.weights[first][4 * i] = 1;
    loose = true;
  }
  if (loose)
    warn_at(document_.file, primitive.place, "has vertices without weight, which hang on their first joint");

  for (std::size_t set = 0; set < 2; ++set)
    for (std::size_t i = 0; i < mesh.joints[set].size(); ++i) {
      if (mesh.weights[set][i] == 0) continue;
      const auto joint = static_cast<std::size_t>(mesh.joints[set][i]);
      if (!is_finite(joints_[joint]))
        throw input_error(
            document_.file,
            "{}: vertices hang on joint {} of their skin, which is no node, or whose inverse bind "
            "matrix is missing or not finite",
            primitive.place, joint);
    }
}

Frame Frames::at(const LocalMesh& mesh, std::size_t i) const {
  if (joints_.empty()) return rigid_;
  glm::dmat4 blended(0);
  double sum = 0;
  for (int set = 0; set < 2; ++set)
    for (std::size_t k = i * 4; k < i * 4 + 4 && k < mesh.joints[set].size(); ++k) {
      const double weight = mesh.weights[set][k];
      if (weight == 0) continue;
      blended += weight * joints_[static_cast<std::size_t>(mesh.joints[set][k])];
      sum += weight;
    }
  // Weights that do not sum to 1 would pull the vertex towards the origin.
  if (!(sum > least_weight)) return rigid_;
  return frame_of(blended / sum);
}

}  // namespace dermis::scene::gltf
