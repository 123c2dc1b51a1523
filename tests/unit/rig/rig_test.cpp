// SPDX-License-Identifier: MIT
// What an asset keeps to be posed again, against an evaluation by hand and against the file loaded in the
// pose.
#include "head/scene/rig/rig.h"

#include <algorithm>
#include <cmath>

#include "../gltf/posed_by_hand.h"
#include "head/scene/framing.h"
#include "head/scene/placement.h"
#include "head/scene/surface/turned.h"
#include "head/scene/surface/unwrap.h"
#include "moved.h"
#include "two_clips.h"

namespace dermis::scene::test {
namespace {

Pose pose_at(const AssetData& scene, std::size_t clip, double seconds) {
  Pose pose = scene.rig->rest;
  play(scene.rig->clips[clip].clip, seconds, pose);
  return pose;
}

AssetData posed_scene(const AssetData& scene, const Pose& pose) {
  AssetData moved = scene;
  take_pose(*scene.rig, posed(*scene.rig, pose, "a test"), moved);
  return moved;
}

std::vector<glm::vec3> directions() {
  std::vector<glm::vec3> found;
  for (const double elevation_deg : {-90.0, -50.0, -20.0, 0.0, 20.0, 50.0, 90.0})
    for (double azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 30)
      found.emplace_back(head_direction(azimuth_deg, elevation_deg));
  return found;
}

float furthest_m(const std::vector<glm::vec3>& points_m, const glm::vec3& direction) {
  float furthest = -INFINITY;
  for (const glm::vec3& p_m : points_m) furthest = std::max(furthest, glm::dot(p_m, direction));
  return furthest;
}

class Character : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = assets();
    if (!folder) GTEST_SKIP() << "the shared assets are not in DERMIS_ASSET_CACHE";
    file_ = *folder / "makehuman" / "mh-african-man-young.glb";
  }
  Warnings quiet_;
  fs::path file_;
  TempFolder temp_;
};

TEST_F(Character, BlendsTwoClips) {
  const fs::path file = with_second_clip(file_, temp_.path() / "two.glb");
  const AssetData scene = load_gltf(file);
  const PosedByHand by_hand(file);
  ASSERT_EQ(scene.clips, (std::vector<std::string>{"performance", "second"}));

  double moved = 0;
  const Points rest = by_hand.positions_m(1, 0);
  for (const double share : {0.0, 0.3, 0.5, 1.0})
    for (const double seconds : {0.2, 0.9, 1.7}) {
      SCOPED_TRACE(testing::Message() << share << " at " << seconds << " s");
      const AssetData found =
          posed_scene(scene, blended(pose_at(scene, 0, seconds), pose_at(scene, 1, 2 * seconds / 3), share));
      const Compared c = compare(found, by_hand.blended_m(0, seconds, 1, 2 * seconds / 3, share));
      EXPECT_LE(c.farthest, 1e-5 * c.size);
      moved = std::max(moved, compare(found, rest).farthest / c.size);
    }
  EXPECT_GT(moved, 0.02) << "the poses differ from each other by far more than the bound";
}

TEST_F(Character, IsAsLoadedInThatPose) {
  const AssetData scene = load_gltf(file_), other = load_gltf(file_, {.time_s = 1.4});
  for (const double seconds : {0.0, 0.7, 1.4}) {
    const AssetData loaded = load_gltf(file_, {.time_s = seconds});
    const Apart a = apart(posed_scene(scene, pose_at(scene, 0, seconds)), loaded);
    std::printf("%.1f s: positions %.1e m, normals %.1e, tangents %.1e\n", seconds, a.positions, a.normals,
                a.tangents);
    EXPECT_LE(a.positions, 1e-6);
    EXPECT_LE(a.normals, 1e-5);
    // Loaded in a pose, an asset can be posed again.
    EXPECT_LE(apart(posed_scene(other, pose_at(other, 0, seconds)), loaded).positions, 1e-6);
  }
  EXPECT_LE(apart(posed_scene(scene, scene.rig->rest), scene).tangents, 1e-5);
}

// Boxes and spheres without reading a vertex hold every vertex, and are not much larger.
TEST_F(Character, BoundsHoldThePose) {
  const AssetData scene = load_gltf(file_);
  double loosest = 0;
  for (int i = 0; i < 11; ++i) {
    Pose pose = pose_at(scene, 0, 0.2 * i);
    const bool natural = i < 10;
    // Far more of every target than a clip has.
    for (NodePose& node : pose)
      for (double& weight : node.weights) weight = natural ? weight : 4;
    const PosedRig rig = posed(*scene.rig, pose, "a test");
    const AssetData moved = posed_scene(scene, pose);
    const Bounds held = posed_bounds(*scene.rig, rig, false), all = posed_bounds(*scene.rig, rig, true),
                 exact = skin_bounds(moved);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE(held.low_m[axis], exact.low_m[axis] + 1e-6);
      EXPECT_GE(held.high_m[axis], exact.high_m[axis] - 1e-6);
    }
    std::vector<glm::vec3> points_m;
    for (const Primitive& primitive : moved.primitives)
      for (const Vertex& v : primitive.vertices) points_m.push_back(v.position_m);
    for (const glm::vec3& p_m : points_m)
      EXPECT_LE(glm::distance(p_m, all.sphere.centre_m), all.sphere.radius_m * (1 + 1e-6));
    const std::vector<glm::vec3> corners_m = posed_corners(*scene.rig, rig);
    for (const glm::vec3& direction : directions())
      EXPECT_GE(furthest_m(corners_m, direction), furthest_m(points_m, direction) - 1e-6f);
    if (natural) loosest = std::max(loosest, double{held.sphere.radius_m} / double{exact.sphere.radius_m});
  }
  std::printf("largest sphere of a pose over that of its vertices: %.2f\n", loosest);
  EXPECT_LE(loosest, 1.25);
}

// Whatever shape a mesh takes, all that turned_neighbours() may find is in the list that holds in every pose.
TEST_F(Character, NeighboursOfEveryPoseAreInOneList) {
  const SkinMesh rest = skin_meshes(load_gltf(file_)).front(),
                 moved = skin_meshes(load_gltf(file_, {.time_s = 1.0})).front();
  const std::vector<std::uint32_t> all = touching_neighbours(rest), turned = turned_neighbours(moved);
  ASSERT_EQ(rest.indices, moved.indices);
  std::size_t entries = 0, kept = 0;
  for (std::size_t t = 0; t < rest.triangle_chart.size(); ++t) {
    const auto begin = all.begin() + all[t], end = all.begin() + all[t + 1];
    for (std::uint32_t k = turned[t]; k < turned[t + 1]; ++k, ++entries)
      kept += std::binary_search(begin, end, turned[k]) || *begin == always_kept ? 1 : 0;
  }
  EXPECT_EQ(kept, entries);
  EXPECT_GT(entries, 0u);
}

// A faulty clip, a target that is no number: the asset is shown, and says why it does not move.
TEST(FaultyRigs, AreShownAtRest) {
  Builder b;
  b.triangle();
  b.json["animations"] = Json::array(
      {{{"samplers",
         {{{"input", b.accessor({1, 0}, "SCALAR")}, {"output", b.accessor({0, 0, 0, 1, 0, 0}, "VEC3")}}}},
        {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}});
  const Warnings warnings;
  const AssetData scene = b.load();
  ASSERT_TRUE(scene.rig);
  EXPECT_ERROR(scene.rig->clips.at(0).error, "times must not fall; 0 s follows 1 s");

  Json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["targets"] = Json::array({{{"POSITION", b.accessor({0, 0, 0, NAN, 0, 0, 0, 0, 0}, "VEC3")}}});
  EXPECT_FALSE(b.load().rig);
  EXPECT_TRUE(warnings.any_with("morph target 0 adds what is not finite to vertex 1"));
}

}  // namespace
}  // namespace dermis::scene::test
