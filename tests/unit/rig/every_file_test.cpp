// SPDX-License-Identifier: MIT
// All files of the assets and of the glTF corpus that have anything to move, one by one: what is valid plays,
// and what is not plays or is refused in one line.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "../gltf/posed_by_hand.h"
#include "../gltf/support.h"
#include "head/scene/rig/rig.h"
#include "moved.h"

namespace dermis::scene::test {
namespace {

Json json_of(const fs::path& file) {
  std::string text = read_text(file);
  if (text.starts_with("glTF") && text.size() > 20) {
    std::uint32_t size = 0;
    std::memcpy(&size, text.data() + 12, 4);
    text = text.substr(20, size);
  }
  return Json::parse(text, nullptr, false);
}

// What a file has that moves.
struct Moving {
  std::size_t clips = 0, skins = 0, targets = 0;
  bool any() const { return clips + skins + targets > 0; }
  bool operator==(const Moving&) const = default;
};

Moving moving_in(const fs::path& file) {
  const Json json = json_of(file);
  Moving found;
  if (!json.is_object()) return found;
  const auto list = [](const Json& of, const char* key) {
    return of.is_object() && of.contains(key) && of[key].is_array() ? of[key] : Json::array();
  };
  found.clips = list(json, "animations").size();
  found.skins = list(json, "skins").size();
  for (const Json& mesh : list(json, "meshes"))
    for (const Json& primitive : list(mesh, "primitives"))
      found.targets = std::max(found.targets, list(primitive, "targets").size());
  return found;
}

std::map<std::string, Moving> moving_files(const fs::path& root, std::initializer_list<const char*> folders) {
  std::map<std::string, Moving> files;
  for (const char* folder : folders)
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".gltf" && extension != ".glb") continue;
      if (const Moving moving = moving_in(entry.path()); moving.any())
        files.emplace(fs::relative(entry.path(), root).generic_string(), moving);
    }
  return files;
}

AssetData in_pose(const AssetData& scene, const Pose& pose) {
  AssetData moved = scene;
  take_pose(*scene.rig, posed(*scene.rig, pose, "a test"), moved);
  return moved;
}

double size_of(const AssetData& scene) {
  return double{posed_bounds(*scene.rig, posed(*scene.rig, scene.rig->rest, ""), true).sphere.radius_m};
}

// By its clips: as an evaluation by hand has them, or, where that cannot read the file, as a load in the
// pose. Returns how far the clips move a vertex, of the size.
double play_clips(const fs::path& file, const AssetData& scene, int times) {
  const PosedByHand by_hand(file);
  double moved = 0;
  for (std::size_t clip = 0; clip < scene.rig->clips.size(); ++clip) {
    EXPECT_EQ(scene.rig->clips[clip].error, "");
    const double end_s = scene.rig->clips[clip].clip.end_s();
    for (int i = 0; i < times; ++i) {
      // Before, between and after the keys.
      const double seconds = end_s * (1.2 * i / (times - 1) - 0.05);
      Pose pose = scene.rig->rest;
      play(scene.rig->clips[clip].clip, seconds, pose);
      const AssetData found = in_pose(scene, pose);
      moved = std::max(moved, apart(found, scene).positions / size_of(scene));
      if (!by_hand.is_compressed()) {
        const Compared c = compare(found, by_hand.positions_m(clip, seconds));
        EXPECT_LE(c.farthest, 1e-5 * c.size) << seconds << " s";
      } else if (seconds >= 0) {
        const AssetData loaded = load_gltf(file, {.clip = scene.clips[clip], .time_s = seconds});
        EXPECT_LE(apart(found, loaded).positions, 1e-5 * size_of(scene)) << seconds << " s";
      }
    }
  }
  return moved;
}

// Without a clip: joints of its skins, and the weights of its targets.
double move_joints_and_weights(const AssetData& scene) {
  double moved = 0;
  for (std::size_t node = 0; node < scene.rig->nodes.size(); ++node) {
    Pose pose = scene.rig->rest;
    for (double& weight : pose[node].weights) weight += 0.5;
    if (!scene.rig->nodes[node].matrix)
      pose[node].transform.rotation *= glm::dquat(std::cos(0.3), 0, 0, std::sin(0.3));
    const AssetData found = in_pose(scene, pose);
    moved = std::max(moved, apart(found, scene).positions / size_of(scene));
    for (const Primitive& primitive : found.primitives)
      for (const Vertex& v : primitive.vertices) EXPECT_TRUE(std::isfinite(glm::length(v.position_m)));
  }
  return moved;
}

TEST(EveryFileThatMoves, Plays) {
  DERMIS_NEED_ASSETS(root);
  const std::string skins = "gltf-valid/gltf-asset-generator/Animation_Skin/Animation_Skin_0";
  const std::map<std::string, Moving> expected{
      {"gltf-valid/assimp/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf", {1, 0, 2}},
      {"gltf-valid/assimp/simple_skin/simple_skin.gltf", {1, 1, 0}},
      {skins + "0.gltf", {0, 1, 0}},
      {skins + "1.gltf", {1, 1, 0}},
      {skins + "2.gltf", {0, 1, 0}},
      {skins + "3.gltf", {0, 1, 0}},
      {skins + "4.gltf", {0, 1, 0}},
      {skins + "5.gltf", {1, 1, 0}},
      {skins + "6.gltf", {1, 2, 0}},
      {skins + "7.gltf", {0, 1, 0}},
      {skins + "8.gltf", {1, 1, 0}},
      {skins + "9.gltf", {0, 1, 0}},
      {"gltf-valid/head-variants/head-anim-meshopt-quantized.glb", {1, 1, 14}},
      {"gltf-valid/head-variants/head-anim-quantized.glb", {1, 1, 14}},
      {"gltf-valid/tinygltf/SparseMorphTargets-issue280/singleBlendshapeCube_sparse.glb", {1, 0, 1}},
      {"ict-facekit/ict-mean-animated.glb", {1, 0, 21}},
      {"makehuman/mh-african-man-young-sub1.glb", {1, 1, 14}},
      {"makehuman/mh-african-man-young.glb", {1, 1, 14}},
      {"makehuman/mh-asian-woman-young-sub1.glb", {1, 1, 14}},
      {"makehuman/mh-asian-woman-young.glb", {1, 1, 14}},
      {"makehuman/mh-european-man-young.glb", {1, 1, 14}},
  };
  const std::map<std::string, Moving> found =
      moving_files(*root, {"gltf-valid", "ict-facekit", "lee-perry-smith", "makehuman"});
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [name, moving] : found) {
    ASSERT_TRUE(expected.contains(name)) << name;
    EXPECT_EQ(expected.at(name), moving) << name;
  }

  const Warnings quiet;
  std::size_t played = 0, moved = 0;
  for (const auto& [name, moving] : found) {
    SCOPED_TRACE(name);
    const AssetData scene = load_gltf(*root / name);
    ASSERT_TRUE(scene.rig);
    EXPECT_EQ(scene.clips.size(), moving.clips);
    const int times = name.find("-sub1") == std::string::npos ? 10 : 3;
    const double by_clips = play_clips(*root / name, scene, times);
    const double moves = moving.clips > 0 ? by_clips : move_joints_and_weights(scene);
    std::printf("%s: %zu clips, %zu skins, %zu targets; moves by %.3f of the size\n", name.c_str(),
                moving.clips, moving.skins, moving.targets, moves);
    moved += moves > 1e-3 ? 1 : 0;
    ++played;
  }
  EXPECT_EQ(played, 21u);
  EXPECT_EQ(moved, 20u) << "the weights of the sparse cube stay 0";
}

// Of the malformed ones most have their fault elsewhere.
TEST(EveryFileThatMoves, MalformedPlaysOrSaysWhyNot) {
  DERMIS_NEED_ASSETS(root);
  const Warnings quiet;
  std::size_t refused = 0, shown = 0, poses = 0, faults = 0;
  for (const auto& [name, moving] : moving_files(*root, {"gltf-malformed"})) {
    SCOPED_TRACE(name);
    const std::string why = error_of(*root / name);
    EXPECT_EQ(why.find('\n'), std::string::npos);
    if (!why.empty()) {
      ++refused;
      continue;
    }
    ++shown;
    const AssetData scene = load_gltf(*root / name);
    EXPECT_EQ(scene.clips.size(), moving.clips);
    for (std::size_t clip = 0; clip < scene.clips.size(); ++clip) {
      const LoadOptions in_clip{.clip = scene.clips[clip], .time_s = 0.5};
      const std::string said = scene.rig ? scene.rig->clips[clip].error : scene.why_no_rig;
      EXPECT_EQ(error_of(*root / name, in_clip), said) << "as a load in the pose";
      faults += said.empty() ? 0 : 1;
      if (!said.empty()) continue;
      Pose pose = scene.rig->rest;
      play(scene.rig->clips[clip].clip, 0.5, pose);
      EXPECT_LE(apart(in_pose(scene, pose), load_gltf(*root / name, in_clip)).positions,
                1e-5 * size_of(scene));
      ++poses;
    }
    if (scene.rig) move_joints_and_weights(scene);
  }
  std::printf("%zu refused, %zu shown, %zu clips play, %zu say why not\n", refused, shown, poses, faults);
  EXPECT_EQ(refused + shown, 60u);
}

}  // namespace
}  // namespace dermis::scene::test
