// SPDX-License-Identifier: MIT
// Reads nodes, skins and scenes; checks that they form a tree.
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"
#include "head/scene/gltf/place.h"

namespace dermis::scene::gltf {

namespace {

constexpr double rounding = 1e-3;  // of the last row of a matrix

glm::dmat4 read_matrix(const Value& value, const std::vector<double>& m) {
  for (const char* other : {"translation", "rotation", "scale"})
    if (value.has(other)) warn_at(value, "has a matrix and its parts; the matrix counts");
  glm::dmat4 matrix;
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];

  const double off = std::max({std::abs(m[3]), std::abs(m[7]), std::abs(m[11]), std::abs(m[15] - 1)});
  if (off == 0) return matrix;
  if (!(off <= rounding)) value.fail("the last row of the matrix must be 0 0 0 1");
  warn_at(value, "the last row of its matrix is not quite 0 0 0 1, which is taken");
  for (glm::length_t column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1 : 0;
  return matrix;
}

glm::dquat read_rotation(const Value& value, const std::vector<double>& r) {
  const glm::dquat q(r[3], r[0], r[1], r[2]);  // glm: w first
  const double length = glm::length(q);
  if (!(length > 1e-6 && std::isfinite(length))) {
    warn_at(value.at("rotation"), "is a quaternion of length 0, and does not turn");
    return {1, 0, 0, 0};
  }
  if (std::abs(length - 1) > 0.01) warn_at(value.at("rotation"), "is no unit quaternion, and is normalised");
  return q / length;
}

Transform read_transform(const Value& value) {
  const std::vector<double> t = value.numbers("translation", 3), r = value.numbers("rotation", 4),
                            s = value.numbers("scale", 3);
  Transform transform;
  if (!t.empty()) transform.translation = {t[0], t[1], t[2]};
  if (!r.empty()) transform.rotation = read_rotation(value, r);
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

// Returns the number of a node of the file; -1 for anything else.
int node_that_is_there(const Value& value, std::size_t nodes) {
  const double number = value.is_number() ? value.any_number() : -1;
  const bool there = number >= 0 && number < static_cast<double>(nodes) && number == std::floor(number);
  return there ? static_cast<int>(number) : -1;
}

std::vector<int> children_that_are_there(const Value& value, std::size_t nodes) {
  const Value list = value.at("children");
  warn_at(list, "name nodes that are not there, and are left out");
  std::vector<int> children;
  for (std::size_t i = 0; list.is_array() && i < list.array_size(0); ++i)
    if (const int child = node_that_is_there(list.element(i), nodes); child >= 0) children.push_back(child);
  return children;
}

Node read_node(const Document& document, const Value& value, std::size_t nodes, std::size_t skins) {
  Node node;
  node.place = value.place();
  node.name = text_near(value, "name", "");
  node.fault = fault_of([&] { read_place(value, node); });
  node.mesh_fault = fault_of([&] {
    node.mesh = value.index_or_none("mesh", document.meshes.size(), "mesh");
    if (node.mesh >= 0) node.skin = value.index_or_none("skin", skins, "skin");
  });
  if (node.mesh < 0) node.skin = index_near(value, "skin", skins, "skin");
  node.camera = index_near(value, "camera", document.cameras.size(), "camera");
  if (const auto light = extension(value, "KHR_lights_punctual"))
    node.light = index_near(*light, "light", document.lights.size(), "light");
  if (const auto visibility = extension(value, "KHR_node_visibility"))
    node.visible = boolean_near(*visibility, "visible", true);
  if (!fault_of([&] { node.children = value.indices("children", nodes, "node"); }).empty())
    node.children = children_that_are_there(value, nodes);

  if (node.mesh < 0 && node.skin >= 0) warn_at(value, "has a skin but no mesh");
  if (node.mesh < 0) node.skin = -1;
  if (node.mesh >= 0) node.weights = read_weights(value, document.meshes[node.mesh].targets);
  return node;
}

/// Takes a node from its parent.
void detach(Document& document, int node) {
  Node& child = document.nodes[static_cast<std::size_t>(node)];
  std::erase(document.nodes[static_cast<std::size_t>(child.parent)].children, node);
  child.parent = -1;
}

/// Opens loops, which no root leads to: one node of each becomes a root.
void open_loops(Document& document) {
  std::vector<bool> in_tree(document.nodes.size(), false);
  for (const int node : parents_first(document)) in_tree[static_cast<std::size_t>(node)] = true;

  std::vector<int> seen_from(document.nodes.size(), -1);
  for (int first = 0; first < static_cast<int>(document.nodes.size()); ++first) {
    if (in_tree[static_cast<std::size_t>(first)]) continue;
    int node = first;
    for (; seen_from[static_cast<std::size_t>(node)] != first;
         node = document.nodes[static_cast<std::size_t>(node)].parent)
      seen_from[static_cast<std::size_t>(node)] = first;
    warn_at(document.file, document.nodes[static_cast<std::size_t>(node)].place,
            "is its own ancestor, and has no parent now");
    detach(document, node);

    std::vector<int> below{node};
    for (std::size_t i = 0; i < below.size(); ++i) {
      in_tree[static_cast<std::size_t>(below[i])] = true;
      const std::vector<int>& children = document.nodes[static_cast<std::size_t>(below[i])].children;
      below.insert(below.end(), children.begin(), children.end());
    }
  }
}

/// Leaves a tree: each node has one parent at most, and none is its own ancestor.
void link_parents(Document& document) {
  for (std::size_t i = 0; i < document.nodes.size(); ++i)
    std::erase_if(document.nodes[i].children, [&](int child) {
      Node& node = document.nodes[static_cast<std::size_t>(child)];
      if (node.parent >= 0) {
        warn_at(document.file, node.place, "has two parents; the first counts");
        return true;
      }
      node.parent = static_cast<int>(i);
      return false;
    });
  open_loops(document);
}

// Returns the joints of a skin, of which some may be no nodes of the file.
std::vector<int> read_joints(const Value& value, std::size_t nodes) {
  const Value list = value.at("joints");
  std::vector<int> joints;
  for (std::size_t i = 0; i < list.array_size(); ++i) {
    joints.push_back(node_that_is_there(list.element(i), nodes));
    if (joints.back() < 0)
      warn_at(list.element(i), "is a joint that is not there, on which nothing may hang");
  }
  return joints;
}

void read_skin(const Document& document, const Value& value, Skin& skin) {
  if (value.has("joints")) skin.joints = read_joints(value, document.nodes.size());
  skin.inverse_bind = value.index_or_none("inverseBindMatrices", document.accessors.size(), "accessor");
  if (skin.inverse_bind < 0) return;
  const Accessor& a = document.accessors[static_cast<std::size_t>(skin.inverse_bind)];
  check_fault(a.fault);
  if (a.columns != 4 || a.rows != 4 || a.component != Component::float32)
    value.fail("inverseBindMatrices must be MAT4 of FLOAT");
}

/// A skin that cannot be used refuses the nodes that are drawn with it; one without joints leaves them where
/// they are.
void read_skins(Document& document, const Value& root) {
  root.for_each("skins", [&](const Value& value) {
    Skin& skin = document.skins.emplace_back();
    skin.fault = fault_of([&] { read_skin(document, value, skin); });
    if (skin.fault.empty() && skin.joints.empty()) warn_at(value, "has no joints");
  });
  for (Node& node : document.nodes)
    if (node.skin >= 0) {
      const Skin& skin = document.skins[static_cast<std::size_t>(node.skin)];
      if (skin.fault.empty() && skin.joints.empty()) node.skin = -1;
    }
}

/// Returns those of the nodes that none of the others leads to, each once.
std::vector<int> without_descendants(const Document& document, const Value& where,
                                     const std::vector<int>& nodes) {
  std::vector<bool> shown(document.nodes.size(), false);  // by what was named, or by a parent
  for (const int node : nodes) shown[static_cast<std::size_t>(node)] = true;
  std::vector<bool> below(document.nodes.size(), false);
  for (const int n : parents_first(document)) {
    const auto node = static_cast<std::size_t>(n);
    if (document.nodes[node].parent < 0) continue;
    below[node] = shown[static_cast<std::size_t>(document.nodes[node].parent)];
    shown[node] = shown[node] || below[node];
  }

  std::vector<int> kept;
  for (const int node : nodes) {
    if (below[static_cast<std::size_t>(node)]) {
      warn_at(where, fmt::format("shows node {} twice", node));
      continue;
    }
    kept.push_back(node);
    below[static_cast<std::size_t>(node)] = true;
  }
  return kept;
}

void read_scenes(Document& document, const Value& root) {
  const std::size_t scenes = root.size_of("scenes");
  if (scenes > 0) {
    const int shown = index_near(root, "scene", scenes, "scene");
    const Value scene = root.at("scenes").element(static_cast<std::size_t>(std::max(shown, 0)));
    const std::vector<int> nodes = scene.object().indices("nodes", document.nodes.size(), "node");
    document.roots = without_descendants(document, scene, nodes);
    return;
  }
  for (std::size_t i = 0; i < document.nodes.size(); ++i)
    if (document.nodes[i].parent < 0) document.roots.push_back(static_cast<int>(i));
}

/// A place that cannot be read refuses what is shown below it, and the skins of which it is a joint.
void check_places(const Document& document) {
  std::vector<std::string> faults(document.nodes.size());  // of the node, or of one above it
  bool any = false;
  for (const int n : parents_first(document)) {
    const Node& node = document.nodes[static_cast<std::size_t>(n)];
    std::string& fault = faults[static_cast<std::size_t>(n)];
    fault = node.fault;
    if (fault.empty() && node.parent >= 0) fault = faults[static_cast<std::size_t>(node.parent)];
    any |= !fault.empty();
  }
  if (!any) return;

  for (const int n : shown_nodes(document)) {
    const Node& node = document.nodes[static_cast<std::size_t>(n)];
    const bool stands = (node.mesh >= 0 && node.skin < 0) || node.camera >= 0 || node.light >= 0;
    if (stands) check_fault(faults[static_cast<std::size_t>(n)]);
    if (node.mesh < 0 || node.skin < 0) continue;
    for (const int joint : document.skins[static_cast<std::size_t>(node.skin)].joints)
      if (joint >= 0) check_fault(faults[static_cast<std::size_t>(joint)]);
  }
  for (const Node& node : document.nodes)
    if (!node.fault.empty())
      warn_at(document.file, node.place, "has a place that cannot be read, and that nothing shown needs");
}

}  // namespace

std::vector<int> parents_first(const Document& document) {
  std::vector<int> order;
  order.reserve(document.nodes.size());
  for (std::size_t i = 0; i < document.nodes.size(); ++i)
    if (document.nodes[i].parent < 0) order.push_back(static_cast<int>(i));
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<int>& children = document.nodes[static_cast<std::size_t>(order[i])].children;
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

void read_nodes(Document& document, const Value& root) {
  const std::size_t nodes = root.size_of("nodes"), skins = root.size_of("skins");
  root.for_each("nodes", [&](const Value& value) {
    document.nodes.push_back(read_node(document, value, nodes, skins));
  });
  link_parents(document);
  read_skins(document, root);
  read_scenes(document, root);
  check_places(document);
}

}  // namespace dermis::scene::gltf
