// SPDX-License-Identifier: MIT
#include "head/scene/gltf/place.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/core/hooks.h"
#include "base/core/warnings.h"
#include "head/scene/gltf/lenient.h"
#include "head/scene/gltf/skinning.h"
#include "head/scene/import/complete.h"
#include "head/scene/import/limits.h"
#include "head/scene/placement.h"

namespace dermis::scene::gltf {

namespace {

// Limit on work: vertices times active morph targets, per vertex limit.
constexpr std::uint64_t morph_passes = 2;

// Primitives and nodes that name the same accessors cost a file a few bytes, and memory for each vertex. So
// many copies are free; beyond them the file must have grown. The densest Draco data that we know holds about
// 4 vertices per byte.
constexpr std::uint64_t free_vertices = 8'000'000, vertices_per_byte = 16;

// Matrices are multiplied from a node up to its root; so deep below it, once for each node.
constexpr int deepest_from_leaf = 64;

constexpr std::uint64_t largest_source_mesh = std::numeric_limits<int>::max();

/// Applies the node's morph targets to the local mesh (glTF 2.0, 3.7.2.2).
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

void check_both_sets(const MeshPlace& place, const Vertex& v, std::size_t i) {
  for (const glm::vec2& uv : {v.uv0, v.uv1}) check_coordinates(place, uv, i);
}

/// Properties of a primitive besides its vertices.
struct About {
  int material = 0, node = -1, source_mesh = 0;
};

/// Returns a primitive without its vertices.
Primitive without_vertices(const Document& document, const LocalMesh& mesh, const About& about) {
  Primitive out;
  const Node& node = document.nodes[about.node];
  out.name = node.name.empty() ? document.meshes[node.mesh].name : node.name;
  out.material = about.material;
  out.node = about.node;
  out.source_mesh = about.source_mesh;
  out.source_vertices = mesh.original;
  out.has_uv = !mesh.uvs[0].empty();
  out.indices = mesh.indices;
  out.vertices.resize(mesh.vertices);
  return out;
}

Primitive place(const Document& document, const MeshPrimitive& source, const LocalMesh& mesh,
                const Frames& frames, const About& about) {
  Primitive out = without_vertices(document, mesh, about);
  std::size_t mirrored = 0;
  for (std::size_t i = 0; i < mesh.vertices; ++i) {
    const Frame frame = frames.at(mesh, i);
    mirrored += frame.mirrored ? 1 : 0;
    out.vertices[i] = place_vertex(mesh, i, frame);
    check_position({document.file, source.place}, out.vertices[i].position_m, i);
    check_both_sets({document.file, source.place}, out.vertices[i], i);
  }

  if (mirrored * 2 > mesh.vertices)  // a mirrored mesh is inside out: restores the winding
    for (std::size_t i = 0; i + 2 < out.indices.size(); i += 3)
      std::swap(out.indices[i + 1], out.indices[i + 2]);
  return out;
}

/// A mesh that stays in its own coordinates.
struct SharedMesh {
  std::size_t primitive = 0;  ///< index into Placed::primitives
  glm::dvec3 middle{0};       ///< subtracted from its positions
  glm::dvec3 half{0};         ///< half size of its box around the middle
};

/// Adds a primitive without placements. Moves positions that are far from the mesh's own origin to it,
/// because the device transforms with floats.
SharedMesh share(const Document& document, const MeshPrimitive& source, const LocalMesh& mesh,
                 const About& about, Placed& placed) {
  constexpr double far = 4;  // half sides of its box
  Primitive& out = placed.primitives.emplace_back(without_vertices(document, mesh, about));
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (std::size_t i = 0; i < mesh.vertices; ++i) {
    out.vertices[i] = place_vertex(mesh, i, Frame{});
    check_both_sets({document.file, source.place}, out.vertices[i], i);
    const glm::dvec3 p(out.vertices[i].position_m);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  placed.file_tangents.push_back(usable_tangents(mesh, out.vertices));
  placed.has_uv.push_back({!mesh.uvs[0].empty(), !mesh.uvs[1].empty()});

  SharedMesh shared{placed.primitives.size() - 1, 0.5 * (low + high), 0.5 * (high - low)};
  if (glm::length(shared.middle) <= far * glm::length(shared.half)) {
    shared.half += glm::abs(shared.middle);
    shared.middle = glm::dvec3(0);
  }
  if (shared.middle != glm::dvec3(0))
    for (Vertex& v : out.vertices) v.position_m = glm::vec3(glm::dvec3(v.position_m) - shared.middle);
  return shared;
}

void add_placement(const Document& document, const MeshPrimitive& source, const SharedMesh& shared,
                   const Frame& frame, int node, Primitive& primitive) {
  Placement& placement = primitive.placements.emplace_back();
  placement.world_from_mesh = glm::dmat4x3(frame.matrix);
  placement.world_from_mesh[3] = glm::dvec3(frame.matrix * glm::dvec4(shared.middle, 1));
  placement.node = node;
  placement.mirrored = frame.mirrored;

  // Checks the box in the world, and single vertices only if the box is too far out.
  glm::dvec3 reach = glm::abs(placement.world_from_mesh[3]);
  for (glm::length_t axis = 0; axis < 3; ++axis)
    reach += glm::abs(placement.world_from_mesh[axis]) * shared.half[axis];
  if (reach.x < largest_position_m && reach.y < largest_position_m && reach.z < largest_position_m) return;
  for (std::uint32_t i = 0; i < primitive.vertices.size(); ++i)
    check_position({document.file, source.place},
                   world_position_m(primitive, primitive.placements.size() - 1, i), i);
}

/// Returns whether a node only transforms the whole mesh, in every pose.
bool is_rigid(const Node& node, const Mesh& mesh) { return node.skin < 0 && mesh.targets == 0; }

/// Returns what a rig needs of a mesh, before its targets are applied.
MovingMesh moving_mesh(const MeshPrimitive& primitive, const LocalMesh& local, int node) {
  MovingMesh moving{.source = &primitive, .local = {}, .nodes = {node}};
  moving.local.vertices = local.vertices;
  moving.local.original = local.original;
  moving.local.positions = local.positions;
  moving.local.normals = local.normals;
  moving.local.tangents = local.tangents;
  moving.local.joints = local.joints;
  moving.local.weights = local.weights;
  return moving;
}

}  // namespace

std::vector<int> shown_nodes(const Document& document) {
  std::vector<int> nodes;  // a tree: no node occurs twice
  const auto add = [&](const std::vector<int>& more) {
    for (const int node : more)
      if (document.nodes[node].visible) nodes.push_back(node);
  };
  add(document.roots);
  for (std::size_t i = 0; i < nodes.size(); ++i) add(document.nodes[nodes[i]].children);
  return nodes;
}

std::vector<glm::dmat4> world_matrices(const Document& document, double unit_scale) {
  const std::size_t count = document.nodes.size();
  std::vector<glm::dmat4> world(count);
  glm::dmat4 units(unit_scale);
  units[3][3] = 1;
  std::vector<int> depth(count, 0);
  for (const int n : parents_first(document)) {
    const auto i = static_cast<std::size_t>(n);
    const int parent = document.nodes[i].parent;
    if (parent >= 0) depth[i] = depth[static_cast<std::size_t>(parent)] + 1;
    world[i] = document.nodes[i].local;
    if (depth[i] <= deepest_from_leaf) {
      for (int up = parent; up >= 0; up = document.nodes[up].parent)
        world[i] = document.nodes[up].local * world[i];
      world[i] = units * world[i];
    } else {
      world[i] = world[static_cast<std::size_t>(parent)] * world[i];
    }
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        if (!std::isfinite(world[i][c][r]))
          throw input_error(document.file, "{}: its place in the world is not finite",
                            document.nodes[i].place);
  }
  return world;
}

std::vector<int> first_source_meshes(const Document& document) {
  std::vector<int> first;
  first.reserve(document.nodes.size());
  std::uint64_t next = 0;
  for (const Node& node : document.nodes) {
    first.push_back(static_cast<int>(next));
    if (node.mesh >= 0) next += document.meshes[node.mesh].primitives.size();
    if (next > largest_source_mesh)
      throw input_error(document.file, "has more than {} primitives at its nodes, the limit",
                        largest_source_mesh);
  }
  return first;
}

void check_limits(const Document& document, std::uint64_t read_bytes, const LoadOptions& options) {
  const std::uint64_t max_triangles = options.max_triangles;
  const std::uint64_t max_vertices =
      std::min<std::uint64_t>(max_triangles * 3, free_vertices + read_bytes * vertices_per_byte);
  std::uint64_t triangles = 0, vertices = 0, morphed = 0, skipped = 0;

  for (const int n : shown_nodes(document)) {
    const Node& node = document.nodes[n];
    check_fault(node.mesh_fault);
    if (node.mesh < 0) continue;
    const Mesh& mesh = document.meshes[node.mesh];
    const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
    const auto active = static_cast<std::uint64_t>(
        std::count_if(weights.begin(), weights.end(), [](double w) { return w != 0; }));

    check_fault(mesh.fault);
    for (const MeshPrimitive& primitive : mesh.primitives) {
      check_fault(primitive.fault);
      const std::uint64_t here = claimed_triangles(document, primitive);
      skipped += primitive.mode < 4 ? 1 : 0;
      if (here == 0) continue;
      triangles += here;
      vertices += claimed_vertices(document, primitive);
      morphed += claimed_vertices(document, primitive) * std::min(active, max_vertices);

      if (triangles > max_triangles)
        throw input_error(document.file, "has more than {} triangles, the limit", max_triangles);
      if (vertices > max_vertices)
        throw input_error(document.file, "has more than {} vertices, the limit for a file of {} bytes",
                          max_vertices, read_bytes);
      if (morphed > max_vertices * morph_passes)
        throw input_error(document.file, "has more morph targets at work than can be applied");
    }
  }

  if (skipped > 0) {
    const std::string line =
        fmt::format("{}: {} primitives of points or lines are left out", document.file, skipped);
    warn_of(line, document.file, line);
  }
  if (triangles == 0) throw input_error(document.file, "there are no triangles to draw");
}

void check_skin_nodes(const Document& document, const MaterialNumbers& materials) {
  std::size_t count = 0;
  for (const int n : shown_nodes(document)) {
    if (document.nodes[n].mesh < 0) continue;
    const std::vector<MeshPrimitive>& primitives = document.meshes[document.nodes[n].mesh].primitives;
    count += std::any_of(primitives.begin(), primitives.end(), [&](const MeshPrimitive& p) {
      return claimed_triangles(document, p) > 0 && p.attributes.contains("TEXCOORD_0") &&
             materials.skin[static_cast<std::size_t>(materials.of.at(p.material))];
    });
  }

  scene::check_skin_nodes(document.file, count);
}

Placed place_meshes(const Document& document, Bytes& bytes, const MaterialNumbers& materials,
                    const LoadOptions& options, bool keep_moving) {
  const std::vector<int> nodes = shown_nodes(document);
  const std::vector<glm::dmat4> world = world_matrices(document, options.unit_scale);
  std::vector<int> users(document.meshes.size());
  std::size_t primitives = 0;
  for (const int n : nodes) {
    if (document.nodes[n].mesh < 0) continue;
    ++users[document.nodes[n].mesh];
    primitives += document.meshes[document.nodes[n].mesh].primitives.size();
  }

  std::map<const MeshPrimitive*, LocalMesh> read;  // read once, placed often
  std::map<const MeshPrimitive*, SharedMesh> shared;
  JointMatrices joints(document, bytes, world);
  Placed placed;
  Steps steps("placing meshes", primitives);
  std::size_t begun = 0;
  const std::vector<int> first_sources = first_source_meshes(document);
  for (const int n : nodes) {
    const Node& node = document.nodes[n];
    if (node.mesh < 0) continue;
    const Mesh& mesh = document.meshes[node.mesh];
    const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
    const Frames frames(document, world[n], joints.of(n));
    const bool several = users[node.mesh] > 1, rigid = is_rigid(node, mesh);
    for (const MeshPrimitive& primitive : mesh.primitives) {
      if (begun++ > 0) steps.done();
      if (claimed_triangles(document, primitive) == 0) continue;
      const auto place_in_mesh = static_cast<int>(&primitive - mesh.primitives.data());
      const About about{materials.of.at(primitive.material), n, first_sources[n] + place_in_mesh};
      const bool skin = materials.skin[static_cast<std::size_t>(about.material)];

      if (several && !read.contains(&primitive))
        read.emplace(&primitive, read_mesh(document, bytes, primitive));
      if (several && rigid && !skin) {
        const LocalMesh& local = read.at(&primitive);
        if (local.indices.empty()) continue;
        if (!shared.contains(&primitive)) {
          shared.emplace(&primitive, share(document, primitive, local, about, placed));
          if (keep_moving)
            placed.moving.push_back({.source = &primitive,
                                     .local = {},
                                     .nodes = {},
                                     .placed = true,
                                     .middle = shared.at(&primitive).middle});
        }
        const SharedMesh& mine = shared.at(&primitive);
        if (keep_moving) placed.moving[mine.primitive].nodes.push_back(n);
        add_placement(document, primitive, mine, frames.of_node(), n, placed.primitives[mine.primitive]);
        continue;
      }

      LocalMesh local = several ? read.at(&primitive) : read_mesh(document, bytes, primitive);
      if (local.indices.empty()) continue;
      frames.repair_weights(local, primitive);
      if (keep_moving) placed.moving.push_back(moving_mesh(primitive, local, n));
      apply_morphs(bytes, primitive, weights, local);
      placed.primitives.push_back(place(document, primitive, local, frames, about));
      placed.file_tangents.push_back(usable_tangents(local, placed.primitives.back().vertices));
      placed.has_uv.push_back({!local.uvs[0].empty(), !local.uvs[1].empty()});
    }
  }
  if (placed.primitives.empty()) throw input_error(document.file, "there are no triangles to draw");
  return placed;
}

}  // namespace dermis::scene::gltf
