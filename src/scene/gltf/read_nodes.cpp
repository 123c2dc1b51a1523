// SPDX-License-Identifier: MIT
// Reads nodes, skins and scenes; checks that they form a tree.
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf/document.h"

namespace dermis::scene::gltf {

namespace {

constexpr int max_depth = 64;

glm::dmat4 read_matrix(const Value& value, const std::vector<double>& m) {
  for (const char* other : {"translation", "rotation", "scale"})
    if (value.has(other)) value.fail("has both matrix and {}", other);
  glm::dmat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[i];
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    value.fail("the last row of the matrix must be 0 0 0 1");
  return matrix;
}

Transform read_transform(const Value& value) {
  const std::vector<double> t = value.numbers("translation", 3), r = value.numbers("rotation", 4),
                            s = value.numbers("scale", 3);
  Transform transform;
  if (!t.empty()) transform.translation = {t[0], t[1], t[2]};
  if (!r.empty()) {
    const glm::dquat q(r[3], r[0], r[1], r[2]);  // glm: w first
    const double length = glm::length(q);
    if (std::abs(length - 1) > 0.01)
      value.at("rotation").fail("must be a unit quaternion, has length {}", length);
    transform.rotation = q / length;
  }
  if (!s.empty()) transform.scale = {s[0], s[1], s[2]};
  return transform;
}

void read_place(const Value& value, Node& node) {
  if (const std::vector<double> m = value.numbers("matrix", 16); !m.empty()) {
    node.local = read_matrix(value, m);
    node.transform.reset();
    return;
  }
  node.transform = read_transform(value);
  node.local = node.transform->matrix();
}

Node read_node(const Document& document, const Value& value, std::size_t nodes, std::size_t skins) {
  Node node;
  node.place = value.place();
  node.name = value.text_or("name", "");
  read_place(value, node);
  node.mesh = value.index_or_none("mesh", document.meshes.size(), "mesh");
  node.skin = value.index_or_none("skin", skins, "skin");
  node.camera = value.index_or_none("camera", document.cameras.size(), "camera");
  if (const auto light = extension(value, "KHR_lights_punctual"))
    node.light = light->index("light", document.lights.size(), "light");
  node.children = value.indices("children", nodes, "node");
  node.weights = value.numbers("weights", 0);

  if (node.mesh < 0 && node.skin >= 0) value.fail("has a skin but no mesh");
  if (node.mesh < 0 && !node.weights.empty()) value.fail("has weights but no mesh");
  if (node.mesh < 0) return node;

  const Mesh& mesh = document.meshes[node.mesh];
  const std::size_t targets = mesh.primitives.front().targets.size();
  if (!node.weights.empty() && node.weights.size() != targets)
    value.fail("has {} weights for {} morph targets", node.weights.size(), targets);
  for (const MeshPrimitive& primitive : mesh.primitives)
    if (node.skin >= 0 && !primitive.attributes.contains("JOINTS_0"))
      value.fail("has a skin, but {} has no JOINTS_0", primitive.place);
  return node;
}

void link_parents(Document& document) {
  for (std::size_t i = 0; i < document.nodes.size(); ++i)
    for (const int child : document.nodes[i].children) {
      Node& node = document.nodes[child];
      if (node.parent >= 0)
        throw input_error(document.file, "{}: has two parents, nodes {} and {}", node.place, node.parent, i);
      node.parent = static_cast<int>(i);
    }
  // Every node has at most one parent here, so the way up either ends at a root or is a loop.
  for (const Node& node : document.nodes) {
    int steps = 0;
    for (int up = node.parent; up >= 0; up = document.nodes[up].parent)
      if (++steps > max_depth || &document.nodes[up] == &node)
        throw input_error(document.file, "{}: {}", node.place,
                          steps > max_depth
                              ? fmt::format("is nested deeper than {} levels, or in a loop", max_depth)
                              : "is its own ancestor");
  }
}

void read_skins(Document& document, const Value& root) {
  root.for_each("skins", [&](const Value& value) {
    Skin skin;
    value.at("joints");
    skin.joints = value.indices("joints", document.nodes.size(), "node");
    value.index_or_none("skeleton", document.nodes.size(), "node");
    skin.inverse_bind = value.index_or_none("inverseBindMatrices", document.accessors.size(), "accessor");
    if (skin.inverse_bind >= 0) {
      const Accessor& a = document.accessors[skin.inverse_bind];
      if (a.columns != 4 || a.rows != 4 || a.component != Component::float32)
        value.fail("inverseBindMatrices must be MAT4 of FLOAT");
      if (a.count < skin.joints.size())
        value.fail("has {} inverseBindMatrices for {} joints", a.count, skin.joints.size());
    }
    document.skins.push_back(std::move(skin));
  });
}

void read_scenes(Document& document, const Value& root) {
  std::vector<std::vector<int>> scenes;
  root.for_each("scenes", [&](const Value& value) {
    scenes.push_back(value.indices("nodes", document.nodes.size(), "node"));
    for (const int node : scenes.back())
      if (document.nodes[node].parent >= 0)
        value.fail("node {} is not a root: it is a child of node {}", node, document.nodes[node].parent);
  });
  const int shown = root.index_or_none("scene", scenes.size(), "scene");
  if (!scenes.empty()) {
    document.roots = scenes[shown >= 0 ? shown : 0];
    return;
  }
  for (std::size_t i = 0; i < document.nodes.size(); ++i)
    if (document.nodes[i].parent < 0) document.roots.push_back(static_cast<int>(i));
}

}  // namespace

void read_nodes(Document& document, const Value& root) {
  const std::size_t nodes = root.size_of("nodes"), skins = root.size_of("skins");
  root.for_each("nodes", [&](const Value& value) {
    document.nodes.push_back(read_node(document, value, nodes, skins));
  });
  link_parents(document);
  read_skins(document, root);
  read_scenes(document, root);
}

}  // namespace dermis::scene::gltf
