// SPDX-License-Identifier: MIT
// Poses of instances: what a scene makes of clips, blends, weights and joints by name, against an evaluation
// by hand.
#include "dermis/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../gltf/posed_by_hand.h"
#include "../rig/moved.h"
#include "../rig/two_clips.h"
#include "api/asset_state.h"
#include "api/scene_state.h"
#include "dermis/scene.h"
#include "head/scene/import/shapes.h"
#include "head/scene/placement.h"
#include "head/scene/surface/measured.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

// The scene of one instance in this pose, as the reference takes it.
std::shared_ptr<const AssetData> posed(const Asset& asset, const std::optional<RigPose>& pose) {
  dermis::Scene scene;
  scene.set_pose(scene.add({.asset = asset}), pose);
  return setup::flattened(api::placed_scene(scene));
}

// What the makers of characters write: joints, two of them turned, and morph targets that are named.
class Character : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = assets();
    if (!folder) GTEST_SKIP() << "the shared assets are not in DERMIS_ASSET_CACHE";
    file_ = *folder / "makehuman" / "mh-african-man-young.glb";
  }

  fs::path file_;
  TempFolder temp_;
};

TEST_F(Character, BlendsTwoClips) {
  const fs::path file = with_second_clip(file_, temp_.path() / "two.glb");
  const Warnings quiet;
  const Asset asset = Asset::load(file);
  const PosedByHand by_hand(file);
  ASSERT_EQ(asset.clips(), (std::vector<std::string>{"performance", "second"}));
  EXPECT_NEAR(asset.clip_end_s("second"), 2, 1e-12);

  double moved = 0;
  const Points rest = by_hand.positions_m(1, 0);
  for (const double share : {0.0, 0.3, 0.5, 1.0})
    for (const double seconds : {0.2, 0.9, 1.7}) {
      SCOPED_TRACE(testing::Message() << share << " at " << seconds << " s");
      const auto scene = posed(asset, RigPose{.clip = ClipTime{"performance", seconds},
                                              .second = ClipTime{"second", 2 * seconds / 3},
                                              .blend = share});
      const Compared c = compare(*scene, by_hand.blended_m(0, seconds, 1, 2 * seconds / 3, share));
      EXPECT_LE(c.farthest, 1e-5 * c.size);
      moved = std::max(moved, compare(*scene, rest).farthest / c.size);
    }
  EXPECT_GT(moved, 0.02) << "the poses differ from each other by far more than the bound";
}

TEST_F(Character, TakesWeightsAndJointsByName) {
  const Warnings quiet;
  const Asset asset = Asset::load(file_);
  const std::vector<std::string> weights = asset.morph_weights(), joints = asset.joints();
  ASSERT_NE(std::find(weights.begin(), weights.end(), "mouth-open"), weights.end());
  const auto rest = posed(asset, {}), open = posed(asset, RigPose{.weights = {{"mouth-open", 1}}});
  EXPECT_GT(apart(*rest, *open).positions, 0.005);
  EXPECT_LE(apart(*rest, *posed(asset, RigPose{.weights = {{"mouth-open", 0}}})).positions, 1e-6);

  // The last vertex of the root's subtree moves with it.
  const auto moved =
      posed(asset, RigPose{.joints = {{.name = joints.back(), .scale = std::array{1.0, 1.5, 1.0}}}});
  EXPECT_GT(apart(*rest, *moved).positions, 1e-4);

  dermis::Scene scene;
  const InstanceId id = scene.add({.asset = asset});
  const std::uint64_t before = scene.changes(id).rig;
  scene.pose(id, "performance", 0.5);
  EXPECT_GT(scene.changes(id).rig, before);
  EXPECT_EQ(scene.instance(id).pose->clip->seconds, 0.5);
  scene.set_pose(id, {});
  EXPECT_EQ(apart(*rest, *setup::flattened(api::placed_scene(scene))).positions, 0);
}

// A clip at a time is kept in a scene file, by instance.
TEST_F(Character, StandsInAScenefileAsItDid) {
  const Warnings quiet;
  const Asset asset = Asset::load(file_, {.clip = "performance"});
  dermis::Scene scene;
  scene.pose(scene.add({.asset = asset}), "performance", 1.0 / 3);
  scene.pose(scene.add({.asset = asset}), "", 1.7);
  scene.add({.asset = asset});
  scene.save(temp_.path() / "scene.json");

  const dermis::Scene again = dermis::Scene::load(temp_.path() / "scene.json");
  const std::vector<InstanceId> ids = again.instances();
  ASSERT_EQ(ids.size(), 3u);
  EXPECT_EQ(again.instance(ids[0]).pose->clip->clip, "performance");
  EXPECT_EQ(again.instance(ids[0]).pose->clip->seconds, 1.0 / 3);
  EXPECT_FALSE(again.instance(ids[2]).pose);
  const Apart a =
      apart(*setup::flattened(api::placed_scene(scene)), *setup::flattened(api::placed_scene(again)));
  EXPECT_EQ(a.positions + a.normals + a.tangents, 0);
}

TEST_F(Character, WeightsAreInASceneFile) {
  const Warnings quiet;
  dermis::Scene scene;
  const Asset asset = Asset::load(file_);
  const InstanceId id = scene.add({.asset = asset});
  scene.add({.asset = asset});
  const auto again = [&] {
    scene.save(temp_.path() / "scene.json");
    return dermis::Scene::load(temp_.path() / "scene.json");
  };
  for (const bool plays : {false, true}) {
    RigPose pose{.weights = {{"mouth-open", 1.0 / 3}, {"eye-left-closure", -0.5}}};
    if (plays) pose.clip = ClipTime{"performance", 0.7};
    scene.set_pose(id, pose);
    const dermis::Scene read = again();
    const std::optional<RigPose>& of_file = read.instance(read.instances()[0]).pose;
    ASSERT_TRUE(of_file && of_file->weights.size() == 2);
    EXPECT_EQ(of_file->clip.has_value(), plays);
    EXPECT_FALSE(read.instance(read.instances()[1]).pose);
    const Apart a =
        apart(*setup::flattened(api::placed_scene(scene)), *setup::flattened(api::placed_scene(read)));
    EXPECT_EQ(a.positions + a.normals + a.tangents, 0);
  }

  const auto with = [&](const std::string& weights) {
    tests::write_text(temp_.path() / "wrong.json",
                      R"({"dermis_scene": 1, "assets": [{"name": "a", "file": ")" + file_.string() +
                          R"("}], "instances": [{"asset": "a", "weights": )" + weights + "}]}");
    return tests::thrown<InputError>([&] { dermis::Scene::load(temp_.path() / "wrong.json"); });
  };
  EXPECT_ERROR(with("{\"mouth-open\": 101}"), "mouth-open");
  EXPECT_ERROR(with("{\"smile\": 1}"), "has no morph weight 'smile'");
  EXPECT_ERROR(with("[1]"), "weights");
}

TEST_F(Character, FaultsAreOneLineAndChangeNothing) {
  const Warnings quiet;
  const Asset asset = Asset::load(file_);
  dermis::Scene scene;
  const InstanceId id = scene.add({.asset = asset});
  scene.pose(id, "performance", 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error = [&](const RigPose& pose) {
    const std::uint64_t before = scene.changes(id).rig;
    const std::string said = tests::thrown<InputError>([&] { scene.set_pose(id, pose); });
    EXPECT_EQ(scene.changes(id).rig, before);
    EXPECT_EQ(said.find('\n'), std::string::npos);
    return said;
  };
  EXPECT_ERROR(error({.clip = ClipTime{"run", 1}}), "has no clip 'run'; there are: performance");
  EXPECT_ERROR(error({.clip = ClipTime{"", nan}}), "clip.seconds must be finite, got nan");
  EXPECT_ERROR(error({.blend = nan}), "blend must be 0 to 1, got nan");
  EXPECT_ERROR(error({.weights = {{"smile", 1}}}),
               "has no morph weight 'smile'; there are: eye-left-closure");
  EXPECT_ERROR(error({.weights = {{"mouth-open", nan}}}), "weight 'mouth-open' must be -100 to 100, got nan");
  EXPECT_ERROR(error({.joints = {{.name = "tail"}}}), "has no joint 'tail'; there are: ");
  const std::string joint = asset.joints().front();
  EXPECT_ERROR(error({.joints = {{.name = joint, .rotation = std::array{0.0, 0.0, 0.0, 0.0}}}}),
               "over 0, got 0");
  EXPECT_ERROR(error({.joints = {{.name = joint, .translation = std::array{0.0, nan, 0.0}}}}), "got nan");
  EXPECT_ERROR(error({.joints = {{.name = asset.joints().back(),
                                  .translation = std::array{1e6, 1e6, 0.0},
                                  .scale = std::array{1000.0, 1000.0, 1000.0}}}}),
               "more than");
  EXPECT_EQ(scene.instance(id).pose->clip->clip, "performance");

  scene.set_pose(id, RigPose{.joints = {{.name = joint, .scale = std::array{1.0, 1.0, 2.0}}}});
  EXPECT_ERROR(tests::thrown<InputError>([&] { scene.save(temp_.path() / "scene.json"); }),
               "it has a pose of two clips or of single joints");
  dermis::Scene still;
  const InstanceId ball = still.add({.asset = Asset::State::make(measured(sphere(0.1)))});
  EXPECT_ERROR(tests::thrown<InputError>([&] { still.pose(ball, "", 0); }),
               "has no clips, joints or morph weights");
}

}  // namespace
}  // namespace dermis::scene::test
