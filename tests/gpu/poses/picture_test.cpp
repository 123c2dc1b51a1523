// SPDX-License-Identifier: MIT
// Pictures of instances in poses: as those of assets that were loaded in the same pose, and without a cost
// for what stands still.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "api/asset_state.h"
#include "base/settings/names.h"
#include "dermis/reference.h"
#include "dermis/session.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/rig/rig.h"
#include "head/scene/surface/measured.h"
#include "image/compare_flip.h"
#include "image/metrics.h"
#include "support/assets.h"
#include "support/log_lines.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

// Camera and light that do not depend on bounds.
RenderSettings close_up(int side, int map_side) {
  RenderSettings s = small_settings("texture-space", side, map_side);
  s.camera.eye_m = {0.1, 0.35, 0.9};
  s.camera.target_m = {0, 0.3, 0.05};
  s.camera.fov_deg = 24;
  s.quality.shadow_size = 2048;
  return s;
}

Scene lit(const Asset& asset) {
  Scene scene;
  scene.add({.asset = asset});
  scene.add_light({.light = {.colour = {3, 2.9, 2.8}, .direction = {-0.5, -0.4, -0.8}}});
  return scene;
}

double psnr(const Picture& a, const Picture& b) { return image::psnr_db(shown(a), shown(b)); }

class PosedPictures : public testing::Test {
 protected:
  void SetUp() override {
    file_ = asset_cache() / "makehuman" / "mh-african-man-young.glb";
    if (const std::string missing = missing_asset({file_}); !missing.empty()) GTEST_SKIP() << missing;
    asset_.emplace(Asset::load(file_));
  }
  std::filesystem::path file_;
  LogLines quiet_;
  std::optional<Asset> asset_;
};

TEST_F(PosedPictures, AreThoseOfTheAssetLoadedInThatPose) {
  for (const bool optimised : {false, true}) {
    RenderSettings s = close_up(160, 512);
    if (!optimised) s = unoptimised(s);
    Scene scene = lit(*asset_);
    const InstanceId head = scene.instances().front();
    const Picture rest = renderer().render(scene, s);
    for (const double seconds : {0.6, 1.3}) {
      scene.pose(head, "performance", seconds);
      const Picture found = renderer().render(scene, s);
      const Picture wanted = renderer().render(lit(Asset::load(file_, {.time_s = seconds})), s);
      const double db = psnr(wanted, found), still = psnr(wanted, rest);
      std::printf("%s, %.1f s: %.1f dB, of the asset at rest %.1f dB\n", optimised ? "optimised" : "whole",
                  seconds, db, still);
      EXPECT_GE(db, 50);
      EXPECT_LE(still, 35);
      EXPECT_EQ(found.statistics.unshaded_reads, 0u);
      EXPECT_EQ(found.statistics.transmission_misses, 0u);
    }
    scene.set_pose(head, {});
    expect_equal_bits(rest, renderer().render(scene, s));
  }
}

// Each technique, and each way that texture space has, draws a head that has moved as one that was loaded so.
TEST_F(PosedPictures, OfEveryTechniqueAreThoseOfTheAssetLoadedInThatPose) {
  std::vector<RenderSettings> all;
  for (const std::string& name : other_than_published())
    all.emplace_back(close_up(128, 256)).technique = name;
  all.push_back(unoptimised(close_up(128, 256)));

  const Scene loaded = lit(Asset::load(file_, {.time_s = 1.3}));
  Scene scene = lit(*asset_);
  scene.pose(scene.instances().front(), "performance", 1.3);
  for (const RenderSettings& s : all) {
    const Picture wanted = renderer().render(loaded, s), found = renderer().render(scene, s);
    const double db = psnr(wanted, found);
    std::printf("%s: %.1f dB\n", s.technique.c_str(), db);
    EXPECT_GE(db, 45);
    EXPECT_EQ(found.statistics.unshaded_reads, 0u);
    EXPECT_EQ(found.statistics.transmission_misses, 0u);
  }
}

TEST_F(PosedPictures, AreNotForThePublishedTechnique) {
  Scene scene = lit(*asset_);
  RenderSettings s = close_up(32, 64);
  s.technique = "published";
  EXPECT_NO_THROW(renderer().render(scene, s));
  scene.pose(scene.instances().front(), "performance", 1.3);
  const std::string said = thrown<InputError>([&] { renderer().render(scene, s); });
  EXPECT_NE(said.find("takes no poses; take texture-space"), std::string::npos) << said;
}

// Gutters bring light across cuts of the unwrap, from places that are found once, on the shape as it was
// loaded. Beside cuts a posed head is as near to one that was loaded in its pose as elsewhere.
TEST_F(PosedPictures, AreAsNearBesideCutsOfTheUnwrap) {
  RenderSettings s = unoptimised(close_up(160, 512));
  s.output.bloom = 0;
  Scene scene = lit(*asset_);
  std::size_t beside_cuts = 0;
  for (const std::array<double, 3>& eye_m :
       {std::array{0.1, 0.35, 0.9}, std::array{-0.75, 0.5, 0.3}, std::array{0.4, 0.4, -0.8}})
    for (const double seconds : {0.6, 1.3}) {
      s.camera.eye_m = eye_m;
      scene.pose(scene.instances().front(), "performance", seconds);
      const Scene loaded = lit(Asset::load(file_, {.time_s = seconds}));
      const Picture wanted = renderer().render(loaded, s), found = renderer().render(scene, s);
      for (const PictureRegion& region : picture_regions(loaded, s)) {
        if ((region.name != "seams" && region.name != "skin") || region.pixels == 0) continue;
        const double db = image::psnr_db(shown(wanted), shown(found), region.mask);
        std::printf("%.1f s, %s: %zu pixels, %.1f dB\n", seconds, region.name.c_str(), region.pixels, db);
        if (region.name == "seams") beside_cuts += region.pixels;
        EXPECT_GE(db, 45) << region.name;
      }
    }
  EXPECT_GT(beside_cuts, 200u);
}

TEST_F(PosedPictures, OptimisedIsAsWhole) {
  Scene scene = lit(*asset_);
  for (const double angle_deg : {0.0, 75.0}) {  // 75: the jaw against the sky
    RenderSettings s = close_up(160, 512);
    const double a = angle_deg * 0.0174532925;
    s.camera.eye_m = {0.9 * std::sin(a), 0.3, 0.9 * std::cos(a)};
    for (const double seconds : {0.4, 1.0, 1.6}) {
      scene.pose(scene.instances().front(), "performance", seconds);
      expect_unseen(renderer().render(scene, unoptimised(s)), renderer().render(scene, s));
    }
  }
}

// What the skin sees of an environment turns with it; what the pose hides or opens is as it was loaded.
// Nothing else differs between these pictures. Without the turn: 41.7 dB.
TEST_F(PosedPictures, HaveTheSkyTurnedWithTheSkin) {
  RenderSettings s = unoptimised(close_up(160, 512));
  s.lighting.environment = "studio";
  Scene scene;
  scene.add({.asset = *asset_});
  double least = 1000;
  for (const double seconds : {0.6, 1.3}) {
    scene.pose(scene.instances().front(), "performance", seconds);
    Scene loaded;
    loaded.add({.asset = Asset::load(file_, {.time_s = seconds})});
    const Picture wanted = renderer().render(loaded, s), found = renderer().render(scene, s);
    const double db = psnr(wanted, found);
    std::printf("studio, %.1f s: %.1f dB, FLIP %.4f\n", seconds, db,
                image::mean_flip(shown(wanted), shown(found)));
    least = std::min(least, db);
  }
  EXPECT_GE(least, 45);
}

// Every frame of a session is the renderer's, whatever was posed before; and a steady frame allocates
// nothing.
TEST_F(PosedPictures, OfASessionAllocateNothing) {
  Scene scene = lit(*asset_);
  const InstanceId first = scene.instances().front();
  const InstanceId second =
      scene.add({.asset = *asset_, .world_from_asset = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.25, 0, 0, 1}});
  scene.pose(second, "performance", 0.2);
  RenderSettings s = close_up(64, 128);
  s.output.exposure_ev = 0;
  Session session(renderer(), {.frames_in_flight = 2});
  DeviceCounters before;
  constexpr int frames = 12;
  for (int i = 0; i < frames; ++i) {
    if (i == 3) before = renderer().counters();
    scene.pose(first, "performance", 0.1 * i);
    if (i % 3 == 0) scene.pose(second, "performance", 1.5 - 0.1 * i);
    const Ticket ticket = session.draw(scene, s);
    if (i + 1 < frames) continue;
    const DeviceCounters after = renderer().counters();
    EXPECT_EQ(after.allocations, before.allocations);
    EXPECT_EQ(after.buffers, before.buffers);
    EXPECT_EQ(after.images, before.images);
    EXPECT_EQ(after.pipelines, before.pipelines);
    EXPECT_EQ(after.idle_waits, before.idle_waits);
    EXPECT_EQ(after.submissions - before.submissions, static_cast<std::uint64_t>(frames - 3));
    expect_equal_bits(renderer().render(scene, s), session.picture(ticket));
  }

  // One stands still, the other is posed no more, and a third comes.
  scene.set_pose(first, {});
  const Ticket rest = session.draw(scene, s);
  expect_equal_bits(renderer().render(scene, s), session.picture(rest));
  scene.remove(second);
  const InstanceId third = scene.add({.asset = *asset_});
  scene.pose(third, "performance", 1.2);
  const Ticket last = session.draw(scene, s);
  expect_equal_bits(renderer().render(scene, s), session.picture(last));
}

// A pose does not depend on the one before, not even where that left nothing of the head.
TEST_F(PosedPictures, DoNotDependOnPosesBefore) {
  Scene scene = lit(*asset_);
  const InstanceId head = scene.instances().front();
  const std::string root = asset_->joints().front();
  RenderSettings s = close_up(64, 128);
  s.output.exposure_ev = 0;
  Session session(renderer());
  const auto scaled = [&](const std::array<double, 3>& scale) {
    return RigPose{.joints = {{.name = root, .scale = scale}}};
  };
  const RigPose plain{.clip = ClipTime{"performance", 1}};
  for (const RigPose& pose : {plain, scaled({0, 0, 0}), plain, scaled({0, 1, 1}), scaled({0, 0, 1}),
                              scaled({-1000, 1e-9, 1}), plain, scaled({1, 1, 1})}) {
    scene.set_pose(head, pose);
    const Picture found = session.picture(session.draw(scene, s));
    expect_equal_bits(renderer().render(scene, s), found);
    for (const float value : found.linear_rgba) ASSERT_TRUE(std::isfinite(value));
  }
}

// A plane that a morph target stretches 2 : 1 and shears by 45 degrees, under a lamp with a hard edge.
scene::AssetData stretching_plane() {
  scene::AssetData made = scene::plane(0.05, glm::dmat2(1), {}, 16);
  scene::Primitive& primitive = made.primitives.front();
  auto rig = std::make_shared<scene::Rig>();
  rig->nodes = {{.name = "plane", .parent = -1, .matrix = {}, .weights = {"stretch"}}};
  rig->order = {0};
  rig->rest.resize(1);
  rig->rest[0].weights = {0};
  rig->first_weight = {0, 1};
  rig->matrices = {{.node = 0}};
  scene::RigMesh& mesh = rig->meshes.emplace_back();
  for (std::uint32_t v = 0; v < primitive.vertices.size(); ++v) {
    const scene::Vertex& vertex = primitive.vertices[v];
    mesh.positions.push_back(vertex.position_m);
    mesh.normals.push_back(vertex.normal);
    mesh.tangents.push_back(glm::vec3(vertex.tangent));
    mesh.first_influence.push_back(v);
    mesh.influences.push_back({.matrix = 0, .weight = 1});
    mesh.first_delta.push_back(v);
    mesh.deltas.push_back({.weight = 0, .position = {vertex.position_m.x + vertex.position_m.y, 0, 0}});
  }
  mesh.first_influence.push_back(static_cast<std::uint32_t>(mesh.influences.size()));
  mesh.first_delta.push_back(static_cast<std::uint32_t>(mesh.deltas.size()));
  scene::fill_bounds(*rig, {true});
  made.rig = rig;
  return made;
}

TEST(PosedSkin, KeepsTheWidthOfItsGaussiansInMillimetres) {
  const auto data = std::make_shared<const scene::AssetData>(stretching_plane());
  RenderSettings s = unoptimised(small_settings("texture-space", 128, 512));
  s.camera.eye_m = {0, 0, 0.3};
  s.camera.target_m = {0, 0, 0};
  s.camera.fov_deg = 20;
  s.lighting.ambient = 0;
  s.lighting.specular = false;
  const auto scene_of = [](const Asset& asset) {
    Scene scene;
    scene.add({.asset = asset});
    scene.add_light({.light = {.type = LightType::spot,
                               .colour = {0.05, 0.05, 0.05},
                               .position_m = {0, 0, 0.2},
                               .direction = {0, 0, -1},
                               .inner_cone_deg = 3.9,
                               .outer_cone_deg = 4}});
    return scene;
  };

  const Asset asset = Asset::State::make(scene::measured(*data));
  Scene scene = scene_of(asset);
  const InstanceId plane = scene.instances().front();
  for (const double weight : {0.25, 1.0, 0.5}) {
    scene.set_pose(plane, RigPose{.weights = {{"stretch", weight}}});
    const Picture found = renderer().render(scene, s);

    scene::AssetData still = *data;
    scene::Pose pose = data->rig->rest;
    pose[0].weights = {weight};
    scene::take_pose(*data->rig, scene::posed(*data->rig, pose, ""), still);
    const Picture wanted =
        renderer().render(scene_of(Asset::State::make(scene::measured(std::move(still)))), s);
    const double db = psnr(wanted, found);
    std::printf("weight %.2f: %.1f dB\n", weight, db);
    EXPECT_GE(db, 55);
    EXPECT_GT(skin_range(found).high, 0.05f);
  }
}

}  // namespace
}  // namespace dermis::tests
