// SPDX-License-Identifier: MIT
#include "head/scene/gltf/read_rig.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/core/assert.h"
#include "head/scene/gltf/lenient.h"
#include "head/scene/gltf/play.h"

namespace dermis::scene::gltf {
namespace {

// Far more than a performance has. Without limits a file of a few bytes could name accessors of zeros for
// hours, and a large one take twice its memory.
constexpr std::uint64_t most_vertices = 5'000'000, most_deltas = 50'000'000, most_key_numbers = 50'000'000;

std::uint64_t claimed_numbers(const Document& document, const AnimationSource& animation) {
  std::uint64_t claimed = 0;
  for (const AnimationSource::Channel& channel : animation.channels) {
    const AnimationSource::Sampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
    for (const int accessor : {sampler.input, sampler.output}) {
      const Accessor& a = document.accessors[accessor];
      claimed += std::min(a.count, most_key_numbers + 1) * static_cast<std::uint64_t>(a.components());
      if (claimed > most_key_numbers) return claimed;
    }
  }
  return claimed;
}

std::vector<RigClip> read_clips(const Document& document, Bytes& bytes) {
  std::vector<RigClip> clips;
  const std::vector<std::string> names = animation_names(document);
  std::uint64_t numbers = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    RigClip& clip = clips.emplace_back();
    clip.clip.name = names[i];
    numbers += claimed_numbers(document, document.animations[i]);
    try {
      if (numbers > most_key_numbers)
        throw input_error(document.file, "animations[{}]: has more than {} numbers with those before it", i,
                          most_key_numbers);
      clip.clip = read_clip(document, bytes, i);
    } catch (const InputError& error) { clip.error = error.what(); }
  }
  return clips;
}

std::vector<RigNode> read_nodes_of(const Document& document) {
  std::vector<RigNode> nodes;
  for (const Node& from : document.nodes) {
    RigNode& node = nodes.emplace_back();
    node.name = from.name;
    node.parent = from.parent;
    if (!from.transform) node.matrix = from.local;
    if (from.mesh >= 0) node.weights = document.meshes[from.mesh].target_names;
  }
  return nodes;
}

// Numbers the matrices of a rig as they are asked for.
class Matrices {
 public:
  Matrices(const Document& document, Bytes& bytes, Rig& rig)
      : document_(document), bytes_(bytes), rig_(rig) {}

  std::uint32_t of_node(int node) {
    const auto [entry, is_new] = nodes_.try_emplace(node, number());
    if (is_new) rig_.matrices.push_back({.node = node});
    return entry->second;
  }

  /// Returns the matrix of the first joint; the others follow.
  std::uint32_t of_skin(int skin) {
    const auto [entry, is_new] = skins_.try_emplace(skin, number());
    if (!is_new) return entry->second;
    const Skin& source = document_.skins[skin];
    check_fault(source.fault);
    const std::vector<float> bind =
        source.inverse_bind >= 0 ? bytes_.floats(source.inverse_bind) : std::vector<float>{};
    for (std::size_t j = 0; j < source.joints.size(); ++j) {
      RigMatrix& matrix = rig_.matrices.emplace_back(RigMatrix{.node = std::max(source.joints[j], 0)});
      // Nothing hangs on joints without a node or a matrix: Frames::repair_weights().
      const auto first = bind.begin() + static_cast<std::ptrdiff_t>(std::min(16 * j, bind.size()));
      if (bind.size() < 16 * (j + 1) ||
          !std::all_of(first, first + 16, [](float f) { return std::isfinite(f); }))
        continue;
      for (int k = 0; k < 16; ++k) matrix.bind[k / 4][k % 4] = double{first[k]};
    }
    return entry->second;
  }

 private:
  std::uint32_t number() const { return static_cast<std::uint32_t>(rig_.matrices.size()); }
  const Document& document_;
  Bytes& bytes_;
  Rig& rig_;
  std::map<int, std::uint32_t> nodes_, skins_;
};

glm::vec3 vec3_at(const std::vector<float>& values, std::size_t i, std::size_t components) {
  return {values[i * components], values[i * components + 1], values[i * components + 2]};
}

// Returns the vertices of the source, for the vertices of the primitive: copies that were split off stand
// last.
std::vector<std::uint32_t> sources_of(const LocalMesh& local, const Primitive& primitive) {
  if (primitive.vertices.size() == local.vertices) return {};
  std::vector<std::uint32_t> sources;
  for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
    const std::uint32_t number = source_vertex(primitive, v);
    const auto found = std::lower_bound(local.original.begin(), local.original.end(), number);
    sources.push_back(v < local.vertices       ? v
                      : local.original.empty() ? number
                                               : static_cast<std::uint32_t>(found - local.original.begin()));
    DERMIS_ASSERT_LT(std::size_t{sources.back()}, local.vertices);
  }
  return sources;
}

void add_influences(const LocalMesh& local, bool skinned, std::uint32_t first_joint, std::uint32_t own,
                    RigMesh& mesh) {
  for (std::size_t v = 0; v < local.vertices; ++v) {
    mesh.first_influence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
    double sum = 0;
    const auto for_each_weight = [&](const auto& visit) {
      for (std::size_t set = 0; skinned && set < 2; ++set)
        for (std::size_t k = 4 * v; k < 4 * v + 4 && k < local.joints[set].size(); ++k)
          if (local.weights[set][k] != 0) visit(local.joints[set][k], double{local.weights[set][k]});
    };
    for_each_weight([&](float, double weight) { sum += weight; });
    // As Frames::at(): without joints a vertex follows the node.
    if (!(sum > 1e-6)) {
      mesh.influences.push_back({.matrix = own, .weight = 1});
      continue;
    }
    for_each_weight([&](float joint, double weight) {
      mesh.influences.push_back({.matrix = first_joint + static_cast<std::uint32_t>(joint),
                                 .weight = static_cast<float>(weight / sum)});
    });
  }
  mesh.first_influence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
}

// Vertices that the targets move, target after target.
struct Targets {
  std::vector<std::uint32_t> vertex;
  std::vector<MorphDelta> delta;
};

Targets read_targets(Bytes& bytes, const MeshPrimitive& primitive, const LocalMesh& local,
                     std::uint32_t first_weight, bool own_tangents, const std::string& file) {
  Targets targets;
  for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
    const auto deltas = [&](const char* semantic) {
      const auto found = primitive.targets[t].find(semantic);
      if (found == primitive.targets[t].end()) return std::vector<float>{};
      return gather(bytes.floats(found->second), 3, local.original);
    };
    const std::vector<float> positions = deltas("POSITION"), normals = deltas("NORMAL"),
                             tangents = own_tangents ? deltas("TANGENT") : std::vector<float>{};
    for (std::size_t v = 0; v < local.vertices; ++v) {
      MorphDelta delta{.weight = first_weight + static_cast<std::uint32_t>(t)};
      if (!positions.empty()) delta.position = vec3_at(positions, v, 3);
      if (!normals.empty()) delta.normal = vec3_at(normals, v, 3);
      if (!tangents.empty()) delta.tangent = vec3_at(tangents, v, 3);
      const glm::vec3 sum = glm::abs(delta.position) + glm::abs(delta.normal) + glm::abs(delta.tangent);
      if (!std::isfinite(sum.x + sum.y + sum.z))
        throw input_error(file, "{}: morph target {} adds what is not finite to vertex {}", primitive.place,
                          t, v);
      if (sum == glm::vec3(0)) continue;
      targets.vertex.push_back(static_cast<std::uint32_t>(v));
      targets.delta.push_back(delta);
    }
  }
  return targets;
}

// Sorts by vertex; of one vertex, targets keep their order.
void add_deltas(const Targets& targets, std::size_t vertices, RigMesh& mesh) {
  mesh.first_delta.assign(vertices + 1, 0);
  for (const std::uint32_t v : targets.vertex) ++mesh.first_delta[v + 1];
  for (std::size_t v = 0; v < vertices; ++v) mesh.first_delta[v + 1] += mesh.first_delta[v];
  std::vector<std::uint32_t> next(mesh.first_delta.begin(), mesh.first_delta.end() - 1);
  mesh.deltas.resize(targets.delta.size());
  for (std::size_t i = 0; i < targets.delta.size(); ++i)
    mesh.deltas[next[targets.vertex[i]]++] = targets.delta[i];
}

// Directions that dermis has made are turned back from the world to the mesh.
void add_directions(const LocalMesh& local, const Primitive& primitive, bool own_tangents,
                    const PosedRig& rest, RigMesh& mesh) {
  const auto matrix_of = [&](std::size_t v) {
    glm::dmat4 mean(0);
    for (std::uint32_t i = mesh.first_influence[v]; i < mesh.first_influence[v + 1]; ++i)
      mean += double{mesh.influences[i].weight} * rest.matrices[mesh.influences[i].matrix];
    return glm::dmat3(mean);
  };
  const auto usable = [](const glm::vec3& v) {
    const float length = glm::length(v);
    return std::isfinite(length) && length > 1e-15f;
  };

  for (std::size_t v = 0; v < local.vertices; ++v) {
    glm::vec3 normal(0);
    if (!local.normals.empty()) normal = vec3_at(local.normals, v, 3);
    if (!usable(normal))
      normal = glm::vec3(glm::transpose(matrix_of(v)) * glm::dvec3(primitive.vertices[v].normal));
    mesh.normals.push_back(normal);
  }

  for (std::size_t v = 0; v < primitive.vertices.size(); ++v) {
    const std::uint32_t from = mesh.source_of(v);
    if (own_tangents) {
      mesh.tangents.push_back(vec3_at(local.tangents, from, 4));
      continue;
    }
    const glm::dmat3 m = matrix_of(from);
    const glm::dvec3 tangent(glm::vec3(primitive.vertices[v].tangent));
    const bool flat = !(std::abs(glm::determinant(m)) > 1e-30);
    mesh.tangents.push_back(glm::vec3((flat ? glm::transpose(m) : glm::inverse(m)) * tangent));
  }
}

}  // namespace

bool can_move(const Document& document) {
  return !document.animations.empty() ||
         std::any_of(document.nodes.begin(), document.nodes.end(), [&](const Node& node) {
           return node.skin >= 0 || (node.mesh >= 0 && document.meshes[node.mesh].targets > 0);
         });
}

std::string too_large_to_pose(const Document& document) {
  std::uint64_t vertices = 0, deltas = 0;
  for (const Node& node : document.nodes) {
    if (node.mesh < 0) continue;
    for (const MeshPrimitive& primitive : document.meshes[node.mesh].primitives) {
      const std::uint64_t here = std::min(claimed_vertices(document, primitive), most_vertices + 1);
      vertices += here;
      deltas += here * primitive.targets.size();
      if (vertices > most_vertices) return fmt::format("more than {} vertices", most_vertices);
      if (deltas > most_deltas) return fmt::format("more than {} vertices of morph targets", most_deltas);
    }
  }
  return {};
}

std::shared_ptr<const Rig> read_rig(const Document& document, Bytes& bytes, double unit_scale,
                                    const std::vector<MovingMesh>& moving,
                                    const std::vector<bool>& own_tangents, const ViewNodes& views,
                                    const AssetData& scene) {
  DERMIS_ASSERT_EQ(moving.size(), scene.primitives.size());
  auto rig = std::make_shared<Rig>();
  rig->unit_scale = unit_scale;
  rig->nodes = read_nodes_of(document);
  rig->order = parents_first(document);
  rig->rest = rest_pose(document);
  rig->clips = read_clips(document, bytes);
  rig->camera_nodes = views.cameras;
  rig->light_nodes = views.lights;
  rig->first_weight = {0};
  for (const NodePose& node : rig->rest)
    rig->first_weight.push_back(rig->first_weight.back() + static_cast<std::uint32_t>(node.weights.size()));

  // Matrices first: directions are turned back by those of the pose in which the scene was placed.
  Matrices matrices(document, bytes, *rig);
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const MovingMesh& from = moving[i];
    RigMesh& mesh = rig->meshes.emplace_back();
    if (from.placed) {
      for (const int node : from.nodes) mesh.placed.push_back(matrices.of_node(node));
      mesh.middle = from.middle;
      for (const Vertex& v : scene.primitives[i].vertices)
        mesh.positions.push_back(glm::vec3(glm::dvec3(v.position_m) + from.middle));
      continue;
    }
    const int skin = document.nodes[from.nodes.front()].skin;
    const std::uint32_t own = matrices.of_node(from.nodes.front());
    mesh.source = sources_of(from.local, scene.primitives[i]);
    for (std::size_t v = 0; v < from.local.vertices; ++v)
      mesh.positions.push_back(vec3_at(from.local.positions, v, 3));
    add_influences(from.local, skin >= 0, skin >= 0 ? matrices.of_skin(skin) : 0, own, mesh);
    const auto node = static_cast<std::size_t>(from.nodes.front());
    add_deltas(read_targets(bytes, *from.source, from.local, rig->first_weight[node], own_tangents[i],
                            document.file),
               from.local.vertices, mesh);
  }

  const PosedRig rest = posed(*rig, rig->rest, document.file);
  std::vector<bool> skin;
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const Primitive& primitive = scene.primitives[i];
    if (!moving[i].placed) add_directions(moving[i].local, primitive, own_tangents[i], rest, rig->meshes[i]);
    skin.push_back(scene.materials[static_cast<std::size_t>(primitive.material)].skin);
  }
  fill_bounds(*rig, skin);
  return rig;
}

}  // namespace dermis::scene::gltf
