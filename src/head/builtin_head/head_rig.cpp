// SPDX-License-Identifier: MIT
#include "head/builtin_head/head_rig.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/core/assert.h"
#include "head/builtin_head/expressions.h"
#include "head/builtin_head/openings.h"
#include "head/builtin_head/parts.h"

namespace dermis::builtin_head {
namespace {

using scene::Influence;
using scene::MorphDelta;
using scene::RigMesh;

enum Joint : std::uint32_t { body, neck, head, jaw, left_eye, right_eye, joint_count };

struct JointSpec {
  const char* name;
  int parent;
  vec3 at_mm;  // of the symmetric face
};
const std::array<JointSpec, joint_count> joints = {{{"body", -1, {0, 0, 0}},
                                                    {"neck", body, {0, -150, -45}},
                                                    {"head", neck, {0, -42, -18}},
                                                    {"jaw", head, jaw_joint},
                                                    {"left eye", head, eye_centre},
                                                    {"right eye", head, eye_centre* vec3(-1, 1, 1)}}};

vec3 world_m(Joint joint) {
  return joint == body ? vec3(0) : to_world_m(from_symmetric(joints[joint].at_mm));
}

// Returns the symmetric point of a vertex, mm.
vec3 symmetric_of(const vec3& world) {
  const vec3 p = world * 1000.0f;
  return to_symmetric({p.x, p.y - Sculpture::eyes_over_origin_mm, p.z});
}

// The neck bends between the collar and the base of the skull, more in front than behind.
std::vector<Influence> skin_influences(const vec3& q) {
  const float height = q.y + 0.35f * q.z;
  const float on_head = smooth_step(-152, -98, height),
              on_neck = (1 - on_head) * smooth_step(-212, -150, height);
  std::vector<Influence> out;
  float sum = 0;
  for (const Influence& one : {Influence{body, 1 - on_head - on_neck}, {neck, on_neck}, {head, on_head}}) {
    if (one.weight <= 1e-4f) continue;
    out.push_back(one);
    sum += one.weight;
  }
  for (Influence& one : out) one.weight /= sum;
  return out;
}

Attachment attachment(int i, int j) {
  Attachment at;
  const auto within = [&](const Opening& o, int column) {
    return column > o.from && column < o.to && std::abs(j - o.middle) <= Openings::half;
  };
  if (within(Openings::mouth, i)) at.lip = j - Openings::mouth.middle;
  if (within(Openings::eye, i) || within(Openings::eye, Openings::columns - i))
    at.lid = j - Openings::eye.middle;
  return at;
}

// Splits what is on the jaw off the head's share.
std::vector<Influence> with_jaw(std::vector<Influence> influences, float share) {
  for (Influence& one : influences) {
    if (one.matrix != head || share < 1e-4f) continue;
    const float whole = one.weight;
    one.weight = whole * (1 - share);
    influences.push_back({jaw, whole * share});
    break;
  }
  std::erase_if(influences, [](const Influence& one) { return one.weight <= 0; });
  return influences;
}

void add_vertex(RigMesh& mesh, const scene::Vertex& v, const std::vector<Influence>& influences) {
  mesh.positions.push_back(v.position_m);
  mesh.normals.push_back(v.normal);
  mesh.tangents.push_back(vec3(v.tangent));
  mesh.influences.insert(mesh.influences.end(), influences.begin(), influences.end());
  mesh.first_influence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
}

// Moves all nodes of the net and returns what that does to its points and normals.
struct Moved {
  std::vector<vec3> by_m, normal;
};

Moved move_net(const Net& net, const std::vector<vec3>& symmetric, Expression expression) {
  Net moved = net;
  Moved out{std::vector<vec3>(net.at_mm.size()), std::vector<vec3>(net.at_mm.size())};
  for (int j = 0; j <= net.rows; ++j) {
    for (int i = 0; i <= net.columns; ++i) {
      const std::size_t k = net.index(i, j);
      const vec3 move = displacement(expression, symmetric[k], attachment(i, j));
      out.by_m[k] = 0.001f * move;
      moved.at_mm[k] += move;
    }
  }

  // The turn of the mesh's own normals is added to those at rest, which are the sculpture's.
  for (int j = 0; j <= net.rows; ++j) {
    for (int i = 0; i <= net.columns; ++i) {
      const std::size_t k = net.index(i, j);
      bool still = true;
      for (const int d : {-1, 1}) {
        still = still && moved.at_mm[net.folded(i + d, j)] == net.at_mm[net.folded(i + d, j)] &&
                moved.at_mm[net.folded(i, j + d)] == net.at_mm[net.folded(i, j + d)];
      }
      if (!still) out.normal[k] = mesh_normal(moved, i, j) - mesh_normal(net, i, j);
    }
  }
  return out;
}

RigMesh skin_mesh(const Net& net, const scene::Primitive& primitive) {
  RigMesh mesh;
  mesh.first_influence = {0};
  mesh.first_delta = {0};
  std::vector<vec3> symmetric;
  for (const scene::Vertex& v : primitive.vertices) symmetric.push_back(symmetric_of(v.position_m));

  std::vector<Moved> moved;
  for (std::size_t e = 0; e < expression_names.size(); ++e)
    moved.push_back(move_net(net, symmetric, static_cast<Expression>(e)));

  for (int j = 0; j <= net.rows; ++j) {
    for (int i = 0; i <= net.columns; ++i) {
      const std::size_t k = net.index(i, j);
      add_vertex(mesh, primitive.vertices[k],
                 with_jaw(skin_influences(symmetric[k]), jaw_share(symmetric[k], attachment(i, j))));
      for (std::uint32_t e = 0; e < moved.size(); ++e) {
        const vec3 by = moved[e].by_m[k], turn = moved[e].normal[k];
        if (glm::length(by) > 1e-6f || glm::length(turn) > 1e-3f)
          mesh.deltas.push_back({.weight = e, .position = by, .normal = turn});
      }
      mesh.first_delta.push_back(static_cast<std::uint32_t>(mesh.deltas.size()));
    }
  }
  return mesh;
}

// Movement of a part beside the skin.
struct PartMotion {
  bool eyes = false;    // each turns about its own centre
  float jaw = 0;        // share of the jaw
  bool lashes = false;  // roll with the lids
  bool brows = false;   // follow the skin
};

PartMotion motion_of(std::string_view name) {
  PartMotion m;
  m.eyes = name == "eyes";
  m.jaw = name == "lower teeth" || name == "lower gum and tongue" ? 1.0f : 0.0f;
  m.lashes = name == "lashes";
  m.brows = name == "brows";
  return m;
}

vec3 part_displacement(const PartMotion& motion, Expression expression, const vec3& q, bool upper_lash) {
  if (motion.jaw > 0 && expression == Expression::jaw_open) {
    const float c = std::cos(jaw_open_rad), s = std::sin(jaw_open_rad);
    const vec3 d = q - jaw_joint;
    return motion.jaw * vec3(0, (c - 1) * d.y - s * d.z, s * d.y + (c - 1) * d.z);
  }
  if (motion.brows && expression == Expression::brows_up) return displacement(expression, q, {});
  const bool its_blink =
      (expression == Expression::blink_left && q.x > 0) || (expression == Expression::blink_right && q.x < 0);
  if (motion.lashes && its_blink) {
    const vec3 d = q - eye_centre * vec3(q.x < 0 ? -1 : 1, 1, 1);
    const float x = std::clamp(std::abs(q.x), 17.5f, 45.5f);
    if (!upper_lash) return {0, 0.9f, 0};
    const float a = blink_turn(x);
    return {0, (std::cos(a) - 1) * d.y - std::sin(a) * d.z, std::sin(a) * d.y + (std::cos(a) - 1) * d.z};
  }
  return vec3(0);
}

RigMesh part_mesh(const scene::Primitive& primitive) {
  RigMesh mesh;
  mesh.first_influence = {0};
  mesh.first_delta = {0};
  const PartMotion motion = motion_of(primitive.name);

  for (const scene::Vertex& v : primitive.vertices) {
    const vec3 q = symmetric_of(v.position_m);
    const Joint joint = motion.eyes ? (q.x > 0 ? left_eye : right_eye) : (motion.jaw > 0 ? jaw : head);
    add_vertex(mesh, v, {{joint, 1.0f}});
    for (std::uint32_t e = 0; e < expression_names.size(); ++e) {
      // Lower lashes hang from roots below the middle of the eye.
      const vec3 by = part_displacement(motion, static_cast<Expression>(e), q, v.uv0.y < 0.78f);
      if (glm::length(by) > 1e-4f) mesh.deltas.push_back({.weight = e, .position = 0.001f * by});
    }
    mesh.first_delta.push_back(static_cast<std::uint32_t>(mesh.deltas.size()));
  }
  return mesh;
}

struct Key {
  float time_s, value;
};

// One track of the clip per morph target, in their order: blinks of 0.2 s, the others one after the other.
const std::array<std::vector<Key>, expression_names.size()> weight_tracks = {{
    {{0.5f, 0},
     {0.58f, 1},
     {0.64f, 1},
     {0.8f, 0},
     {2.3f, 0},
     {2.38f, 1},
     {2.45f, 1},
     {2.6f, 0},
     {4.75f, 0},
     {4.83f, 1},
     {4.9f, 1},
     {5.05f, 0}},
    {{0.5f, 0},
     {0.58f, 1},
     {0.64f, 1},
     {0.8f, 0},
     {2.3f, 0},
     {2.38f, 1},
     {2.45f, 1},
     {2.6f, 0},
     {4.75f, 0},
     {4.83f, 1},
     {4.9f, 1},
     {5.05f, 0}},
    {{3.3f, 0}, {3.6f, 1}, {3.85f, 0.9f}, {4.2f, 0}},
    {{1.9f, 0}, {2.3f, 0.9f}, {2.9f, 1}, {3.4f, 0}},
    {{0.9f, 0}, {1.2f, 1}, {1.6f, 0.9f}, {1.9f, 0}},
    {{4.1f, 0}, {4.5f, 1}, {4.9f, 0.9f}, {5.3f, 0}},
}};

float track_at(const std::vector<Key>& track, float time_s) {
  if (time_s <= track.front().time_s) return track.front().value;
  for (std::size_t k = 1; k < track.size(); ++k) {
    if (time_s <= track[k].time_s)
      return glm::mix(track[k - 1].value, track[k].value,
                      smooth_step(track[k - 1].time_s, track[k].time_s, time_s));
  }
  return track.back().value;
}

void add_turns(scene::Clip& clip, Joint joint, const std::vector<glm::vec4>& keys) {
  // Time [s], then turns about y, x and z [degrees].
  scene::KeyFrames frames;
  frames.size = 4;
  for (const glm::vec4& key : keys) {
    constexpr double degree = 0.017453292519943295;
    const glm::dquat q = glm::angleAxis(key.y * degree, glm::dvec3(0, 1, 0)) *
                         glm::angleAxis(key.z * degree, glm::dvec3(1, 0, 0)) *
                         glm::angleAxis(key.w * degree, glm::dvec3(0, 0, 1));
    frames.times_s.push_back(key.x);
    for (const double value : {q.x, q.y, q.z, q.w}) frames.values.push_back(static_cast<float>(value));
  }
  clip.channels.push_back({clip.key_frames.size(), joint, scene::AnimatedPath::rotation});
  clip.key_frames.push_back(std::move(frames));
}

scene::Clip life() {
  scene::Clip clip;
  clip.name = "life";
  scene::KeyFrames weights;
  weights.size = expression_names.size();
  constexpr int frames = 150;  // 25 per second
  for (int f = 0; f <= frames; ++f) {
    const float time_s = 6.0f * static_cast<float>(f) / frames;
    weights.times_s.push_back(time_s);
    for (const auto& track : weight_tracks) weights.values.push_back(track_at(track, time_s));
  }
  clip.channels.push_back({0, body, scene::AnimatedPath::weights});
  clip.key_frames.push_back(std::move(weights));

  add_turns(
      clip, neck,
      {{0, 0, 0, 0}, {1.2f, 4, 1, 0}, {2.6f, -4, -1, 1}, {4.2f, -2, 1, -1}, {5.2f, 2, 0, 0}, {6, 0, 0, 0}});
  add_turns(
      clip, head,
      {{0, 0, 0, 0}, {1.2f, 9, 3, 1}, {2.6f, -10, -2, 2}, {4.2f, -5, 2, -2}, {5.2f, 5, -1, 1}, {6, 0, 0, 0}});
  const std::vector<glm::vec4> gaze = {{0, 0, 0, 0},     {0.55f, 0, 0, 0}, {0.65f, 8, -3, 0},
                                       {1.9f, 7, -3, 0}, {2.4f, -9, 2, 0}, {3.6f, -7, 3, 0},
                                       {4.8f, 5, 0, 0},  {5.4f, 0, 0, 0},  {6, 0, 0, 0}};
  add_turns(clip, left_eye, gaze);
  add_turns(clip, right_eye, gaze);
  return clip;
}

}  // namespace

std::shared_ptr<const scene::Rig> make_rig(const Net& net, const scene::AssetData& scene) {
  auto rig = std::make_shared<scene::Rig>();
  for (std::uint32_t k = 0; k < joint_count; ++k) {
    const JointSpec& joint = joints[k];
    scene::RigNode node;
    node.name = joint.name;
    node.parent = joint.parent;
    scene::NodePose pose;
    const vec3 at = world_m(static_cast<Joint>(k));
    pose.transform.translation =
        at - (joint.parent < 0 ? vec3(0) : world_m(static_cast<Joint>(joint.parent)));
    if (k == body) {
      node.weights.assign(expression_names.begin(), expression_names.end());
      pose.weights.assign(expression_names.size(), 0.0);
    }
    rig->first_weight.push_back(k == body ? 0 : static_cast<std::uint32_t>(expression_names.size()));
    rig->nodes.push_back(std::move(node));
    rig->order.push_back(static_cast<int>(k));
    rig->rest.push_back(std::move(pose));
    glm::dmat4 bind(1);
    bind[3] = glm::dvec4(-glm::dvec3(at), 1);
    rig->matrices.push_back({.node = static_cast<int>(k), .bind = bind});
  }
  rig->first_weight.push_back(static_cast<std::uint32_t>(expression_names.size()));

  std::vector<bool> skin;
  for (const scene::Primitive& part : scene.primitives) {
    skin.push_back(scene.materials[static_cast<std::size_t>(part.material)].skin);
    rig->meshes.push_back(skin.back() ? skin_mesh(net, part) : part_mesh(part));
  }
  rig->clips.push_back({.clip = life(), .error = {}});
  scene::fill_bounds(*rig, skin);
  return rig;
}

}  // namespace dermis::builtin_head
