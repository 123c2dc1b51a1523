// SPDX-License-Identifier: MIT
#include "head/scene/rig/rig.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/parallel.h"
#include "head/scene/surface/local_mesh.h"
#include "head/scene/views.h"

namespace dermis::scene {
namespace {

bool finite(const glm::dmat4& m) {
  for (glm::length_t c = 0; c < 4; ++c)
    for (glm::length_t r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

glm::dvec3 unit_or_other(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1e-30 && std::isfinite(length) ? v / length : otherwise;
}

// The matrix of a vertex: the mean of those that it hangs on (glTF 2.0, 3.7.3.3).
Frame frame_at(const RigMesh& mesh, const PosedRig& pose, std::uint32_t vertex) {
  glm::dmat4 mean(0);
  for (std::uint32_t i = mesh.first_influence[vertex]; i < mesh.first_influence[vertex + 1]; ++i)
    mean += double{mesh.influences[i].weight} * pose.matrices[mesh.influences[i].matrix];
  return frame_of(mean);
}

void move_vertex(const RigMesh& mesh, const PosedRig& pose, std::size_t number, Vertex& v) {
  const std::uint32_t from = mesh.source_of(number);
  glm::dvec3 p(mesh.positions[from]), n(mesh.normals[from]), t(mesh.tangents[number]);
  for (std::uint32_t i = mesh.first_delta[from]; i < mesh.first_delta[from + 1]; ++i) {
    const MorphDelta& delta = mesh.deltas[i];
    const double weight = pose.weights[delta.weight];
    p += weight * glm::dvec3(delta.position);
    n += weight * glm::dvec3(delta.normal);
    t += weight * glm::dvec3(delta.tangent);
  }

  const Frame frame = frame_at(mesh, pose, from);
  v.position_m = glm::vec3(frame.matrix * glm::dvec4(p, 1));
  // Where a matrix leaves no direction, one that does not depend on the pose before.
  const glm::dvec3 normal =
      unit_or_other(frame.normal_matrix * n, unit_or_other(mesh.normals[from], {0, 0, 1}));
  v.normal = glm::vec3(normal);
  const glm::dvec3 along = glm::dmat3(frame.matrix) * t;
  const glm::dvec3 tangent = unit_or_other(along - normal * glm::dot(normal, along),
                                           unit_or_other(mesh.tangents[number], {1, 0, 0}));
  v.tangent = glm::vec4(glm::vec3(tangent), v.tangent.w);
}

// The most by which a matrix stretches a length.
double largest_stretch(const glm::dmat4& m) {
  double most = 0;
  const glm::dmat3 squared = glm::transpose(glm::dmat3(m)) * glm::dmat3(m);
  for (glm::length_t c = 0; c < 3; ++c)
    most = std::max(most, std::abs(squared[c].x) + std::abs(squared[c].y) + std::abs(squared[c].z));
  return std::sqrt(most);
}

// A box of what hangs on a matrix, while it is collected.
struct Collected {
  glm::vec3 low{INFINITY}, high{-INFINITY};
  std::map<std::uint32_t, MorphReach> reach;

  void add(const glm::vec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

constexpr int cells_per_side = 8;

int cell_of(const Collected& box, const glm::vec3& p) {
  const glm::vec3 at =
      (p - box.low) / glm::max(box.high - box.low, glm::vec3(1e-20f)) * static_cast<float>(cells_per_side);
  const glm::ivec3 cell = glm::clamp(glm::ivec3(at), 0, cells_per_side - 1);
  return (cell.z * cells_per_side + cell.y) * cells_per_side + cell.x;
}

std::span<const MorphDelta> deltas_of(const RigMesh& mesh, std::size_t vertex) {
  if (!mesh.placed.empty()) return {};
  return std::span(mesh.deltas)
      .subspan(mesh.first_delta[vertex], mesh.first_delta[vertex + 1] - mesh.first_delta[vertex]);
}

// Calls visit(mesh, vertex of the source, matrix) for all that hangs on anything.
template <class Visit>
void for_each_influence(const Rig& rig, const Visit& visit) {
  for (std::size_t m = 0; m < rig.meshes.size(); ++m) {
    const RigMesh& mesh = rig.meshes[m];
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (const std::uint32_t matrix : mesh.placed) visit(m, v, matrix);
      if (!mesh.placed.empty()) continue;
      for (std::uint32_t i = mesh.first_influence[v]; i < mesh.first_influence[v + 1]; ++i)
        visit(m, v, mesh.influences[i].matrix);
    }
  }
}

// The box of what hangs on a matrix, with what morph targets may move it by.
struct MovedBox {
  glm::dvec3 low, high;
};

MovedBox box_of(const RigBounds& part, const PosedRig& pose) {
  MovedBox box{glm::dvec3(part.low), glm::dvec3(part.high)};
  for (const MorphReach& morph : part.reach) {
    const double weight = pose.weights[morph.weight];
    const glm::dvec3 a = weight * glm::dvec3(morph.low), b = weight * glm::dvec3(morph.high);
    box.low += glm::min(a, b);
    box.high += glm::max(a, b);
  }
  return box;
}

}  // namespace

PosedRig posed(const Rig& rig, const Pose& pose, const std::string& file) {
  DERMIS_ASSERT_EQ(pose.size(), rig.nodes.size());
  glm::dmat4 units(rig.unit_scale);
  units[3][3] = 1;

  std::vector<glm::dmat4> world(rig.nodes.size());
  for (const int n : rig.order) {
    const auto i = static_cast<std::size_t>(n);
    const RigNode& node = rig.nodes[i];
    const glm::dmat4 local = node.matrix ? *node.matrix : pose[i].transform.matrix();
    world[i] = (node.parent < 0 ? units : world[static_cast<std::size_t>(node.parent)]) * local;
  }

  const auto checked = [&](const glm::dmat4& matrix, int node) {
    if (!finite(matrix))
      throw input_error(file, "in this pose node {} ('{}') is not at a finite place", node,
                        rig.nodes[static_cast<std::size_t>(node)].name);
    return matrix;
  };

  PosedRig out;
  for (const RigMatrix& matrix : rig.matrices)
    out.matrices.push_back(checked(world[static_cast<std::size_t>(matrix.node)] * matrix.bind, matrix.node));
  for (const int node : rig.camera_nodes)
    out.cameras.push_back(checked(world[static_cast<std::size_t>(node)], node));
  for (const int node : rig.light_nodes)
    out.lights.push_back(checked(world[static_cast<std::size_t>(node)], node));
  for (const NodePose& node : pose)
    out.weights.insert(out.weights.end(), node.weights.begin(), node.weights.end());
  return out;
}

void take_pose(const Rig& rig, const PosedRig& pose, AssetData& scene) {
  DERMIS_ASSERT_EQ(rig.meshes.size(), scene.primitives.size());
  parallel_for(rig.meshes.size(), [&](std::size_t m) {
    const RigMesh& mesh = rig.meshes[m];
    Primitive& primitive = scene.primitives[m];
    for (std::size_t i = 0; i < mesh.placed.size(); ++i) {
      const glm::dmat4& matrix = pose.matrices[mesh.placed[i]];
      primitive.placements[i].world_from_mesh = glm::dmat4x3(matrix);
      primitive.placements[i].world_from_mesh[3] = glm::dvec3(matrix * glm::dvec4(mesh.middle, 1));
    }
    if (!mesh.placed.empty()) return;
    for (std::size_t v = 0; v < primitive.vertices.size(); ++v)
      move_vertex(mesh, pose, v, primitive.vertices[v]);
  });

  DERMIS_ASSERT_EQ(pose.cameras.size(), scene.cameras.size());
  DERMIS_ASSERT_EQ(pose.lights.size(), scene.lights.size());
  for (std::size_t i = 0; i < scene.cameras.size(); ++i) stand_at(pose.cameras[i], scene.cameras[i]);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) stand_at(pose.lights[i], scene.lights[i]);
}

glm::dvec3 posed_position_m(const AssetData& scene, const PosedRig& pose, std::size_t primitive,
                            std::size_t vertex) {
  const RigMesh& mesh = scene.rig->meshes[primitive];
  Vertex v = scene.primitives[primitive].vertices[vertex];
  if (mesh.placed.empty()) {
    move_vertex(mesh, pose, vertex, v);
    return v.position_m;
  }
  const glm::dmat4& matrix = pose.matrices[mesh.placed.front()];
  return matrix * glm::dvec4(glm::dvec3(v.position_m) + mesh.middle, 1);
}

// A vertex is a mean of the places that the matrices move it to, so it lies within what holds all of these.
std::vector<glm::vec3> posed_corners(const Rig& rig, const PosedRig& pose) {
  std::vector<glm::vec3> corners;
  for (const RigBounds& part : rig.bounds) {
    const MovedBox box = box_of(part, pose);
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec4 p(0, 0, 0, 1);
      for (glm::length_t axis = 0; axis < 3; ++axis)
        p[axis] = (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis];
      corners.emplace_back(pose.matrices[part.matrix] * p);
    }
  }
  return corners;
}

Bounds posed_bounds(const Rig& rig, const PosedRig& pose, bool all) {
  struct Ball {
    glm::dvec3 centre;
    double radius;
  };
  std::vector<Ball> balls;
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const RigBounds& part : rig.bounds) {
    if (!all && !part.skin) continue;
    const glm::dmat4& m = pose.matrices[part.matrix];
    const MovedBox box = box_of(part, pose);
    const glm::dvec3 middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
    const glm::dvec3 centre(m * glm::dvec4(middle, 1));
    glm::dvec3 extent(0);
    for (glm::length_t axis = 0; axis < 3; ++axis) extent += glm::abs(glm::dvec3(m[axis])) * half[axis];
    low = glm::min(low, centre - extent);
    high = glm::max(high, centre + extent);
    balls.push_back({centre, largest_stretch(m) * glm::length(half)});
  }
  if (balls.empty()) return {};

  Bounds bounds{.low_m = glm::vec3(low), .high_m = glm::vec3(high), .sphere = {}};
  bounds.sphere.centre_m = glm::vec3(0.5 * (low + high));
  double radius = 0;
  for (const Ball& ball : balls)
    radius = std::max(radius, glm::distance(ball.centre, glm::dvec3(bounds.sphere.centre_m)) + ball.radius);
  bounds.sphere.radius_m = static_cast<float>(std::min(radius, 0.5 * glm::length(high - low)) * (1 + 1e-6));
  return bounds;
}

void fill_bounds(Rig& rig, const std::vector<bool>& skin) {
  DERMIS_ASSERT_EQ(skin.size(), rig.meshes.size());

  // Bounds of the vertices of a matrix, first as a whole, then in cells, so that a morph target does not
  // enlarge all of them.
  std::map<std::pair<std::uint32_t, bool>, Collected> whole;
  for_each_influence(rig, [&](std::size_t m, std::size_t v, std::uint32_t matrix) {
    whole[{matrix, skin[m]}].add(rig.meshes[m].positions[v]);
  });

  std::map<std::tuple<std::uint32_t, bool, int>, Collected> cells;
  for_each_influence(rig, [&](std::size_t m, std::size_t v, std::uint32_t matrix) {
    const RigMesh& mesh = rig.meshes[m];
    const Collected& box = whole[{matrix, skin[m]}];
    Collected& cell = cells[{matrix, skin[m], cell_of(box, mesh.positions[v])}];
    cell.add(mesh.positions[v]);
    for (const MorphDelta& delta : deltas_of(mesh, v)) {
      MorphReach& reach = cell.reach.try_emplace(delta.weight, MorphReach{delta.weight}).first->second;
      reach.low = glm::min(reach.low, delta.position);
      reach.high = glm::max(reach.high, delta.position);
    }
  });

  rig.bounds.clear();
  for (const auto& [key, cell] : cells) {
    RigBounds& part = rig.bounds.emplace_back();
    part = {.matrix = std::get<0>(key),
            .skin = std::get<1>(key),
            .low = cell.low,
            .high = cell.high,
            .reach = {}};
    for (const auto& [weight, reach] : cell.reach) part.reach.push_back(reach);
  }
}

}  // namespace dermis::scene
