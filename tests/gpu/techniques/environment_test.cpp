// SPDX-License-Identifier: MIT
// Light from a picture of the surroundings: white stays white, turning it turns the light and nothing else,
// what is optimised shows nothing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dermis/cancelled.h"
#include "gpu/support/failure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "image/codec.h"
#include "support/files.h"

namespace dermis::tests {
namespace {

// Written once: a file that is written again is another environment, which the renderer prepares again.
const std::string& white_surroundings() {
  static const std::string file = [] {
    const std::string path = (program_folder() / "white-surroundings.exr").string();
    image::save_exr(path, {.width = 2, .height = 1, .channels = 3, .values = std::vector<float>(6, 1.0f)});
    return path;
  }();
  return file;
}

RenderSettings lit_by_studio(const std::string& technique) {
  RenderSettings s = small_settings(technique);
  s.lighting.rig_lights = 0;
  s.lighting.environment = "studio";
  return s;
}

class EveryTechniqueInSurroundings : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, EveryTechniqueInSurroundings, testing::ValuesIn(technique_names()),
                         [](const auto& technique) { return test_name_of(technique.param); });

class EveryHeadInSurroundings : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Heads, EveryHeadInSurroundings, testing::Values("sphere", "built-in head", "scan"),
                         [](const auto& head) { return test_name_of(head.param); });

// Folds see less of the sky, and white skin instead of it.
TEST_P(EveryHeadInSurroundings, IsWhiteInAWhiteFurnace) {
  const Subject& head = subject(GetParam());
  if (!head.missing.empty()) GTEST_SKIP() << head.missing;
  for (const std::string& technique : technique_names())
    for (const bool specular : {false, true}) {
      SCOPED_TRACE(technique + (specular ? " with specular" : ""));
      RenderSettings s = furnace_settings(technique, specular);
      s.lighting.ambient = 0;
      s.lighting.environment = white_surroundings();
      const SkinRange skin = skin_range(renderer().render(head.open(), s));
      EXPECT_GT(skin.pixels, 1000u);
      EXPECT_GE(skin.low, 0.99);
      EXPECT_LE(skin.high, 1.01);
    }
}

// On a sphere, the eye turning with the surroundings sees the same picture, but for its facets: a polygon of
// n corners lacks 2 pi^2 / 3 n^2 of a disc, here by how the ball of 4 x 32 facets is turned.
TEST_P(EveryTechniqueInSurroundings, TurningThemTurnsTheLight) {
  constexpr double facets = 2 * std::numbers::pi * std::numbers::pi / 3 / (128 * 128);
  const Scene ball = sphere(0.1);
  RenderSettings s = lit_by_studio(GetParam());
  std::array<double, 3> first{}, mean{};

  for (int k = 0; k < 8; ++k) {
    s.lighting.environment_rotation_deg = 45.0 * k;
    s.camera.orbit_deg = {45.0 * k, 0};
    const std::array<double, 3> turned = sum(renderer().render(ball, s));
    s.camera.orbit_deg = {0, 0};
    const std::array<double, 3> still = sum(renderer().render(ball, s));

    for (std::size_t c = 0; c < 3; ++c) {
      if (k == 0) first[c] = turned[c];
      EXPECT_NEAR(turned[c], first[c], (facets + half_rounding) * first[c]) << k;
      mean[c] += still[c] / 8;
    }
    EXPECT_TRUE(k != 4 || std::abs(still[0] - first[0]) > 0.1 * first[0]) << "the bright side is behind now";
  }

  // A full turn is none, up to the rounding of its sine. No side is dark: the lamps stand in a grey room.
  s.lighting.environment_rotation_deg = 360;
  const std::array<double, 3> whole = sum(renderer().render(ball, s));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(whole[c], first[c], half_rounding * first[c]);
    EXPECT_GT(mean[c], 0.4 * first[c]);
  }
}

TEST_P(EveryTechniqueInSurroundings, IntensityIsLinearAndZeroIsBlack) {
  const Scene ball = sphere(0.1);
  RenderSettings s = lit_by_studio(GetParam());
  s.output.bloom = 0;
  const std::array<double, 3> one = sum(renderer().render(ball, s));
  s.lighting.environment_intensity = 2;
  const std::array<double, 3> two = sum(renderer().render(ball, s));
  s.lighting.environment_intensity = 0;
  const std::array<double, 3> none = sum(renderer().render(ball, s));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_GT(one[c], 0);
    EXPECT_NEAR(two[c], 2 * one[c], 4 * half_rounding * two[c]);
    EXPECT_EQ(none[c], 0);
  }
}

TEST_P(EveryTechniqueInSurroundings, TwoRunsAreBitEqual) {
  const RenderSettings s = lit_by_studio(GetParam());
  Renderer other;
  expect_equal_bits(renderer().render(sphere(0.1), s), other.render(sphere(0.1), s));
}

using ScanInSurroundings = WithScan;

TEST_F(ScanInSurroundings, WhatIsOptimisedDoesNotShow) {
  RenderSettings s = lit_by_studio("texture-space");
  s.camera.orbit_deg = {30, 10};
  const Picture all = renderer().render(scan(), s), none = renderer().render(scan(), unoptimised(s));
  EXPECT_EQ(all.statistics.unshaded_reads, 0u);
  EXPECT_LT(all.statistics.launched, none.statistics.launched);
  expect_unseen(none, all);
}

TEST(Surroundings, ValidationIsSilent) {
  if (!is_validated()) GTEST_SKIP() << "the validation layers are not installed";
  renderer().render(sphere(0.1), lit_by_studio("texture-space"));
}

TEST(Surroundings, UnknownOnesAreRefusedAndNothingChanges) {
  RenderSettings s = small_settings("texture-space");
  PreparedFrame frame = renderer().prepare(sphere(0.1), s);
  const std::vector<float> before = frame.picture().linear_rgba;
  s.lighting.environment = "moon";
  EXPECT_THROW(frame.set(s), InputError);
  EXPECT_EQ(frame.picture().linear_rgba, before);
}

// What is baked is never kept here, so each run of the test bakes anew.
TEST(Environment, AFrameStoppedWhileItIsPreparedIsNotDrawn) {
  std::atomic<bool> stop{false};
  Renderer own({.hooks = {.stop = &stop}});
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  RenderSettings s = small_settings("texture-space");
  s.output.width = s.output.height = 32;
  s.quality.map_size = 32;
  PreparedFrame frame = own.prepare(scene, s);

  stop = true;
  RenderSettings lit = s;
  lit.lighting.environment = "studio";
  EXPECT_THROW(frame.set(lit), Cancelled);
  EXPECT_THROW(frame.draw(), Cancelled);

  stop = false;
  frame.set(s);
  EXPECT_GT(frame.draw(), 0);
}

}  // namespace
}  // namespace dermis::tests
