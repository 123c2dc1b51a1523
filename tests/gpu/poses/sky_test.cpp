// SPDX-License-Identifier: MIT
// The light of an environment on skin that has moved: as on the same skin, loaded where it is now.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "api/asset_state.h"
#include "api/planned_frame.h"
#include "api/rig_pose.h"
#include "dermis/session.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "head/scene/rig/rig.h"
#include "head/scene/surface/measured.h"
#include "image/compare_flip.h"
#include "image/metrics.h"
#include "support/assets.h"
#include "support/log_lines.h"

namespace dermis::tests {
namespace {

RenderSettings in_the_studio(int side, int map_side) {
  RenderSettings s = unoptimised(small_settings("texture-space", side, map_side));
  s.camera.eye_m = {0.1, 0.35, 0.9};
  s.camera.target_m = {0, 0.3, 0.05};
  s.camera.fov_deg = 24;
  s.lighting.rig_lights = 0;
  s.lighting.environment = "studio";
  s.output.exposure_ev = 0;
  return s;
}

Scene alone(const Asset& asset, const std::optional<RigPose>& pose = {}) {
  Scene scene;
  scene.add({.asset = asset, .pose = pose});
  return scene;
}

// The asset with its vertices moved by the processor; all that is found of a shape is found of this one.
Asset moved(const Asset& asset, const RigPose& pose) {
  const scene::AssetData& data = *Asset::State::of(asset);
  scene::AssetData still = data;
  scene::take_pose(*data.rig, api::posed_asset(data, pose)->rig, still);
  return Asset::State::make(scene::measured(std::move(still)));
}

double psnr_of_sky(const Picture& a, const Picture& b) { return image::psnr_db(shown(a), shown(b)); }

std::array<double, 4> about_y(double angle_deg) {
  const double half = angle_deg * std::numbers::pi / 360;
  return {0, std::sin(half), 0, std::cos(half)};
}

class SkyOfPoses : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string missing = missing_asset({file_of(man), file_of(mean)}); !missing.empty())
      GTEST_SKIP() << missing;
    man_.emplace(Asset::load(file_of(man)));
  }
  static constexpr const char *man = "makehuman/mh-african-man-young.glb",
                              *mean = "ict-facekit/ict-mean-animated.glb";
  static std::filesystem::path file_of(const char* name) { return asset_cache() / name; }
  LogLines quiet_;
  std::optional<Asset> man_;
};

// What a pose itself hides or opens stays as it was: shoulders under a head that turns, the inside of a
// mouth.
TEST_F(SkyOfPoses, IsNearThatOfTheMovedShape) {
  const RenderSettings s = in_the_studio(160, 512);
  struct Case {
    const char* name;
    const Asset& asset;
    RigPose pose;
    double least_db;
  };
  const Asset face = Asset::load(file_of(mean));
  const auto turned = [](const char* joint) {
    return RigPose{.joints = {{.name = joint, .rotation = about_y(60)}}};
  };
  const auto played = [](double seconds) { return RigPose{.clip = ClipTime{"performance", seconds}}; };
  // If the light of the sky stays at rest: 29.1, 29.3, 29.9, 44.8, 39.2 and 38.1 dB.
  const Case cases[] = {{"root turned by 60 degrees", *man_, turned("root"), 55},
                        {"neck turned by 60 degrees", *man_, turned("neck"), 34},
                        {"head turned by 60 degrees", *man_, turned("head"), 37.5},
                        {"performance, 0.6 s", *man_, played(0.6), 47},
                        {"performance, 1.3 s", *man_, played(1.3), 45},
                        {"jawOpen", face, {.weights = {{"jawOpen", 1}}}, 39}};
  for (const Case& c : cases) {
    const Picture wanted = renderer().render(alone(moved(c.asset, c.pose)), s),
                  found = renderer().render(alone(c.asset, c.pose), s);
    const double db = psnr_of_sky(wanted, found);
    std::printf("%s: %.1f dB, FLIP %.4f\n", c.name, db, image::mean_flip(shown(wanted), shown(found)));
    EXPECT_GE(db, c.least_db) << c.name;
  }
}

// A head whose root is turned is the head in an instance that is turned: nothing but rounding differs, on all
// ways to light and to shade it.
TEST_F(SkyOfPoses, IsThatOfAnInstanceTurnedAsMuch) {
  const double a = 60 * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
  Scene turned;
  turned.add({.asset = *man_, .world_from_asset = {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1}});
  const Scene posed = alone(*man_, RigPose{.joints = {{.name = "root", .rotation = about_y(60)}}});

  std::vector<RenderSettings> all;
  for (const std::string& name : other_than_published())
    all.emplace_back(in_the_studio(128, 256)).technique = name;
  all.push_back(unoptimised(in_the_studio(128, 256)));
  for (const RenderSettings& one : all) {
    const double db = psnr_of_sky(renderer().render(turned, one), renderer().render(posed, one));
    std::printf("%s: %.1f dB\n", one.technique.c_str(), db);
    EXPECT_GE(db, 65);
  }
}

// Instances of one asset have their own poses, and the one at rest the bits that it has alone.
TEST_F(SkyOfPoses, IsEachInstancesOwn) {
  const RenderSettings s = in_the_studio(128, 256);
  const Picture rest = renderer().render(alone(*man_), s);

  Scene scene = alone(*man_);
  const InstanceId first = scene.instances().front();
  std::vector<InstanceId> others;
  for (const double x_m : {0.5, -0.5}) {  // out of the picture, one in a pose
    const Instance beside{.asset = *man_,
                          .world_from_asset = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x_m, 0, 0, 1}};
    others.push_back(scene.add(beside));
  }
  scene.set_pose(others[0], RigPose{.joints = {{.name = "root", .rotation = about_y(60)}}});
  expect_equal_bits(rest, renderer().render(scene, s));

  scene.set_pose(first, RigPose{.joints = {{.name = "root", .rotation = about_y(-40)}}});
  const Picture posed = renderer().render(scene, s);
  expect_equal_bits(posed, renderer().render(scene, s));
  EXPECT_GE(psnr_of_sky(posed, renderer().render(alone(*man_, scene.instance(first).pose), s)), 100);
  EXPECT_LE(psnr_of_sky(posed, rest), 30);

  // In a row all heads share a pose; and the same frame after another sky is as before.
  RenderSettings turned = s;
  turned.lighting.environment_rotation_deg = 70;
  EXPECT_LE(psnr_of_sky(posed, renderer().render(scene, turned)), 40);
  expect_equal_bits(posed, renderer().render(scene, s));
  scene.set_pose(first, {});
  expect_equal_bits(rest, renderer().render(scene, s));
}

// Counts the instances whose light is found anew, frame by frame.
TEST_F(SkyOfPoses, IsFoundOnlyWhereItChanges) {
  const auto state = std::make_shared<Renderer::State>(Renderer::Options{});
  api::PlannedFrame frame(state);
  gpu::FrameMemory memory(state->device, "frame");
  RenderSettings s = in_the_studio(64, 128);
  Scene scene = alone(*man_);
  const InstanceId first = scene.instances().front(), second = scene.add({.asset = *man_});
  bool plans = false;
  const auto turns = [&] {
    plans = frame.set(scene, s);
    memory.clear();
    return frame.data(memory).sky_turns.size();
  };

  EXPECT_EQ(turns(), 0u);
  EXPECT_FALSE(frame.setup().plan.poses);
  scene.pose(first, "performance", 0.4);
  EXPECT_EQ(turns(), 1u);
  EXPECT_EQ(turns(), 0u) << "nothing has moved";
  scene.pose(second, "performance", 0.7);
  EXPECT_EQ(turns(), 2u) << "a new plan";
  scene.pose(second, "performance", 0.8);
  EXPECT_EQ(turns(), 1u);

  // The sky turns, and comes back; light of the lamps alone is none of it.
  s.lighting.environment_rotation_deg = 20;
  EXPECT_EQ(turns(), 2u);
  s.lighting.environment_intensity = 2;
  EXPECT_EQ(turns(), 0u);
  s.lighting.environment = "";
  EXPECT_EQ(turns(), 0u);
  s.lighting.environment = "studio";
  EXPECT_EQ(turns(), 2u);
  // Turned against the sky, first with another plan, for heads that stand otherwise.
  scene.set_transform(second, {0.8, 0, -0.6, 0, 0, 1, 0, 0, 0.6, 0, 0.8, 0, 0, 0, 0, 1});
  EXPECT_EQ(turns(), plans ? 2u : 1u);
  scene.set_transform(second, {0.8, 0, 0.6, 0, 0, 1, 0, 0, -0.6, 0, 0.8, 0, 0, 0, 0, 1});
  EXPECT_EQ(turns(), 1u);
  EXPECT_FALSE(plans);
  scene.set_pose(first, {});
  EXPECT_EQ(turns(), 1u) << "a new plan";
  scene.set_pose(second, {});
  EXPECT_EQ(turns(), 0u);
}

// Frames of a session are the renderer's, and steady ones allocate nothing.
TEST_F(SkyOfPoses, OfASessionAllocatesNothing) {
  const RenderSettings s = in_the_studio(64, 128);
  Scene scene = alone(*man_);
  const InstanceId head = scene.instances().front();
  Session session(renderer(), {.frames_in_flight = 2});
  DeviceCounters before;
  constexpr int frames = 8;
  for (int i = 0; i < frames; ++i) {
    if (i == 3) before = renderer().counters();
    scene.pose(head, "performance", 0.15 * i);
    const Ticket ticket = session.draw(scene, s);
    if (i + 1 < frames) continue;
    const DeviceCounters after = renderer().counters();
    EXPECT_EQ(after.allocations, before.allocations);
    EXPECT_EQ(after.images, before.images);
    EXPECT_EQ(after.idle_waits, before.idle_waits);
    EXPECT_EQ(after.submissions - before.submissions, static_cast<std::uint64_t>(frames - 3));
    expect_equal_bits(renderer().render(scene, s), session.picture(ticket));
  }
}

}  // namespace
}  // namespace dermis::tests
