// SPDX-License-Identifier: MIT
#include "scene/gltf/place.h"

#include <algorithm>
#include <cmath>

#include "core/log.h"
#include "scene/gltf/skinning.h"

namespace dermis::scene::gltf {

namespace {

// far beyond any head; keeps squares and sums of float positions finite
constexpr double largest_position_m = 1e6;
constexpr float largest_uv = 1e5f;  // more repeats of a map than any picture shows
// limit on work: vertices times active morph targets, per vertex limit
constexpr std::uint64_t morph_passes = 2;

/// The local mesh with the node's morph targets applied (glTF 2.0, 3.7.2.2).
void apply_morphs(Bytes& bytes, const MeshPrimitive& primitive, const std::vector<double>& weights,
                  LocalMesh& mesh) {
  for (std::size_t t = 0; t < primitive.targets.size() && t < weights.size(); ++t) {
    if (weights[t] == 0) continue;
    const auto add = [&](const char* semantic, std::vector<float>& to, int components) {
      const auto found = primitive.targets[t].find(semantic);
      if (found == primitive.targets[t].end() || to.empty()) return;
      const std::vector<float> deltas = gather(bytes.floats(found->second), 3, mesh.original);
      for (std::size_t i = 0; i < mesh.vertices; ++i)
        for (int c = 0; c < 3; ++c)
          to[i * components + c] += static_cast<float>(weights[t] * deltas[i * 3 + c]);
    };
    add("POSITION", mesh.positions, 3);
    add("NORMAL", mesh.normals, 3);
    add("TANGENT", mesh.tangents, 4);
  }
}

/// Whether the file's tangents can be used as placed: next to normals, with a direction, with a handedness.
bool usable_tangents(const LocalMesh& mesh, const std::vector<Vertex>& placed) {
  if (mesh.tangents.empty() || mesh.normals.empty()) return false;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const bool has_sign = std::abs(std::abs(mesh.tangents[i * 4 + 3]) - 1) < 0.01f;
    if (!has_sign || placed[i].normal == glm::vec3(0) || glm::vec3(placed[i].tangent) == glm::vec3(0))
      return false;
  }
  return true;
}

/// Unit, or zero where there is no direction: make_missing_normals fills those in.
glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-30 && std::isfinite(length) ? glm::vec3(v / length) : glm::vec3(0);
}

glm::dvec3 vec3_at(const std::vector<float>& values, std::size_t i, int components) {
  return {values[i * components], values[i * components + 1], values[i * components + 2]};
}

Vertex place_vertex(const LocalMesh& mesh, std::size_t i, const Frame& frame) {
  Vertex v;
  v.position_m = glm::vec3(frame.matrix * glm::dvec4(vec3_at(mesh.positions, i, 3), 1));
  v.normal =
      mesh.normals.empty() ? glm::vec3(0) : unit_or_zero(frame.normal_matrix * vec3_at(mesh.normals, i, 3));
  if (!mesh.tangents.empty()) {
    const glm::dvec3 n(v.normal), t = glm::dmat3(frame.matrix) * vec3_at(mesh.tangents, i, 4);
    const float w = mesh.tangents[i * 4 + 3] < 0 ? -1.0f : 1.0f;
    v.tangent = glm::vec4(unit_or_zero(t - n * glm::dot(n, t)), frame.mirrored ? -w : w);
  }
  if (!mesh.uvs[0].empty()) v.uv0 = {mesh.uvs[0][i * 2], mesh.uvs[0][i * 2 + 1]};
  if (!mesh.uvs[1].empty()) v.uv1 = {mesh.uvs[1][i * 2], mesh.uvs[1][i * 2 + 1]};
  for (int c = 0; c < 4 && !mesh.colours.empty(); ++c)
    v.colour[c] = std::clamp(mesh.colours[i * 4 + c], 0.0f, 1.0f);
  return v;
}

void check_vertex(const Document& document, const MeshPrimitive& primitive, const Vertex& v, std::size_t i) {
  const glm::vec3 p = glm::abs(v.position_m);
  if (!(p.x <= largest_position_m && p.y <= largest_position_m && p.z <= largest_position_m))
    throw input_error(document.file, "{}: vertex {} lies at ({}, {}, {}) m, more than {} m from the origin",
                      primitive.place, i, v.position_m.x, v.position_m.y, v.position_m.z, largest_position_m);
  for (const glm::vec2& uv : {v.uv0, v.uv1})
    if (std::abs(uv.x) > largest_uv || std::abs(uv.y) > largest_uv)
      throw input_error(document.file, "{}: texture coordinates ({}, {}) of vertex {} are out of range",
                        primitive.place, uv.x, uv.y, i);
}

Primitive place(const Document& document, const MeshPrimitive& source, const LocalMesh& mesh,
                const Frames& frames, int node) {
  Primitive out;
  const std::string& name = document.nodes[node].name;
  out.name = name.empty() ? document.meshes[document.nodes[node].mesh].name : name;
  out.material = source.material;
  out.node = node;
  out.has_uv = !mesh.uvs[0].empty();
  out.vertices.resize(mesh.vertices);
  std::size_t mirrored = 0;
  for (std::size_t i = 0; i < mesh.vertices; ++i) {
    const Frame frame = frames.at(mesh, i);
    mirrored += frame.mirrored ? 1 : 0;
    out.vertices[i] = place_vertex(mesh, i, frame);
    check_vertex(document, source, out.vertices[i], i);
  }
  out.indices = mesh.indices;
  if (mirrored * 2 > mesh.vertices)  // a mirrored mesh is turned inside out: wind it back
    for (std::size_t i = 0; i + 2 < out.indices.size(); i += 3)
      std::swap(out.indices[i + 1], out.indices[i + 2]);
  return out;
}

/// What the file claims is held against the limits before any of it is read.
void check_limits(const Document& document, const std::vector<int>& nodes, const LoadOptions& options) {
  const std::uint64_t max_triangles = options.max_triangles, max_vertices = max_triangles * 3;
  std::uint64_t triangles = 0, vertices = 0, morphed = 0, skipped = 0;
  for (const int n : nodes) {
    const Node& node = document.nodes[n];
    if (node.mesh < 0) continue;
    const Mesh& mesh = document.meshes[node.mesh];
    const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
    const auto active = static_cast<std::uint64_t>(
        std::count_if(weights.begin(), weights.end(), [](double w) { return w != 0; }));
    for (const MeshPrimitive& primitive : mesh.primitives) {
      const std::uint64_t here = claimed_triangles(document, primitive);
      skipped += primitive.mode < 4 ? 1 : 0;
      if (here == 0) continue;
      triangles += here;
      vertices += claimed_vertices(document, primitive);
      morphed += claimed_vertices(document, primitive) * std::min(active, max_vertices);
      if (triangles > max_triangles)
        throw input_error(document.file, "has more than {} triangles, the limit", max_triangles);
      if (vertices > max_vertices)
        throw input_error(document.file, "has more than {} vertices, the limit", max_vertices);
      if (morphed > max_vertices * morph_passes)
        throw input_error(document.file, "has more morph targets at work than can be applied");
    }
  }
  if (skipped > 0) warn("{}: {} primitives of points or lines are left out", document.file, skipped);
  if (triangles == 0) throw input_error(document.file, "there are no triangles to draw");
}

}  // namespace

std::vector<int> shown_nodes(const Document& document) {
  std::vector<int> nodes = document.roots;  // a tree: nothing comes twice
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::vector<int>& children = document.nodes[nodes[i]].children;
    nodes.insert(nodes.end(), children.begin(), children.end());
  }
  return nodes;
}

std::vector<glm::dmat4> world_matrices(const Document& document, double unit_scale) {
  const std::size_t count = document.nodes.size();
  std::vector<glm::dmat4> world(count);
  glm::dmat4 units(unit_scale);
  units[3][3] = 1;
  for (std::size_t i = 0; i < count; ++i) {
    world[i] = document.nodes[i].local;
    for (int up = document.nodes[i].parent; up >= 0; up = document.nodes[up].parent)
      world[i] = document.nodes[up].local * world[i];
    world[i] = units * world[i];
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        if (!std::isfinite(world[i][c][r]))
          throw input_error(document.file, "{}: its place in the world is not finite",
                            document.nodes[i].place);
  }
  return world;
}

Placed place_meshes(const Document& document, Bytes& bytes, const LoadOptions& options) {
  const std::vector<int> nodes = shown_nodes(document);
  check_limits(document, nodes, options);
  const std::vector<glm::dmat4> world = world_matrices(document, options.unit_scale);
  std::vector<int> users(document.meshes.size());
  for (const int n : nodes)
    if (document.nodes[n].mesh >= 0) ++users[document.nodes[n].mesh];
  std::map<const MeshPrimitive*, LocalMesh> instanced;  // read once, placed often
  JointMatrices joints(document, bytes, world);
  Placed placed;
  for (const int n : nodes) {
    const Node& node = document.nodes[n];
    if (node.mesh < 0) continue;
    const Mesh& mesh = document.meshes[node.mesh];
    const Frames frames(document, world[n], joints.of(n));
    for (const MeshPrimitive& primitive : mesh.primitives) {
      if (claimed_triangles(document, primitive) == 0) continue;
      const bool keep = users[node.mesh] > 1;
      if (keep && !instanced.contains(&primitive))
        instanced.emplace(&primitive, read_mesh(document, bytes, primitive));
      LocalMesh local = keep ? instanced.at(&primitive) : read_mesh(document, bytes, primitive);
      if (local.indices.empty()) continue;
      apply_morphs(bytes, primitive, node.weights.empty() ? mesh.weights : node.weights, local);
      frames.check_joints(local, primitive);
      placed.primitives.push_back(place(document, primitive, local, frames, n));
      placed.file_tangents.push_back(usable_tangents(local, placed.primitives.back().vertices));
    }
  }
  if (placed.primitives.empty()) throw input_error(document.file, "there are no triangles to draw");
  return placed;
}

}  // namespace dermis::scene::gltf
