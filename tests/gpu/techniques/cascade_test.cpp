// SPDX-License-Identifier: MIT
// The cascade of blurs in whole pictures: heads, masks, budgets and light through the body, against the chain
// of whole maps. Its convolutions by themselves are held by tests/gpu/diffusion.
#include "dermis/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "image/metrics.h"
#include "settings/names.h"

namespace dermis::tests {
namespace {

RenderSettings small_cascade() { return with_cascade(small_settings("texture-space", 128, 512)); }

const Scene& head() {
  static const Scene built_in = Scene::built_in();
  return built_in;
}

class CascadeOfHeads : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!subject(GetParam()).missing.empty()) GTEST_SKIP() << subject(GetParam()).missing;
  }
};
INSTANTIATE_TEST_SUITE_P(Heads, CascadeOfHeads,
                         testing::Values("sphere", "built-in head", "scan", "MakeHuman"),
                         [](const auto& one) { return test_name_of(one.param); });

// Under white light from everywhere white skin is white: nothing is lost between maps, at seams and open
// borders, or in the gutters of a level.
TEST_P(CascadeOfHeads, AreWhiteInAWhiteFurnace) {
  RenderSettings s = with_cascade(furnace_settings("texture-space", false));
  s.quality.map_size = 512;
  const Scene scene = subject(GetParam()).open();
  for (const double distance : {3.0, 8.0})
    for (const bool optimised : {true, false}) {
      SCOPED_TRACE(std::to_string(distance) + " radii" + (optimised ? ", optimised" : ""));
      s.camera.distance = distance;
      s.quality.cull = s.quality.depth = s.quality.clip = optimised;
      const Picture picture = renderer().render(scene, s);
      const SkinRange skin = skin_range(picture);
      EXPECT_GT(skin.pixels, 100u);
      EXPECT_GE(skin.low, 0.99);
      EXPECT_LE(skin.high, 1.005);
      EXPECT_EQ(picture.statistics.unshaded_reads, 0u);
    }
}

// Heads of a batch share the maps of each level; those of the next batch find nothing of the first in them.
TEST(Cascade, TwoHeadsOfABatchAreAsByThemselves) {
  RenderSettings s = small_cascade();
  s.camera.heads = 3;
  s.camera.distance = 6;
  s.quality.depth = false;
  s.quality.map_budget_mb = 60;
  const Picture together = renderer().render(head(), s);
  s.quality.map_budget_mb = 28;  // one head at 512 takes 24 MB
  const Picture in_turns = renderer().render(head(), s);
  EXPECT_GT(in_turns.statistics.passes.size(), together.statistics.passes.size());
  EXPECT_LT(in_turns.statistics.image_bytes, together.statistics.image_bytes);

  // Coordinates round by where a cell lies in its pool: half floats of light differ in a last bit here and
  // there (2e-12). Light of another head would show in its whole size.
  EXPECT_LT(image::rel_mse(linear(together), linear(in_turns)), 1e-9);
}

// A head that uses nearly all texels of T_max halves its maps less often than one that uses all: its halved
// maps need more room than those of a near head. Two of them lie side by side.
TEST(Cascade, HeadsOfNearlyAllTexelsHaveRoom) {
  RenderSettings s = small_settings("texture-space", 160, 1024);
  s.quality.shadow_size = 256;
  s.output.bloom = 0;
  s.camera.heads = 2;
  for (const double distance : {1.95, 2.3}) {
    s.camera.distance = distance;
    const Picture cascade = renderer().render(head(), with_cascade(s));
    const int used = std::ranges::max(cascade.statistics.used_size);
    SCOPED_TRACE(used);
    EXPECT_GT(used, 512);
    EXPECT_LT(used, 1024);
    expect_unseen(renderer().render(head(), with_chain(unoptimised(s))), cascade);
  }
}

// Light that comes through the body joins the terms that spread it, on whatever level they are.
TEST(Cascade, LightThroughTheBodyIsThatOfTheChain) {
  RenderSettings whole = small_settings("texture-space", 128, 512);
  whole.output.bloom = 0;
  whole.lighting.placed_lights = {{.azimuth_deg = 160, .elevation_deg = 10}};
  RenderSettings dark = whole;
  dark.skin.translucency = false;
  const Picture a = renderer().render(head(), with_chain(unoptimised(whole))),
                b = renderer().render(head(), with_cascade(whole)),
                none = renderer().render(head(), with_cascade(dark));
  EXPECT_EQ(b.statistics.transmission_misses, 0u);
  EXPECT_EQ(b.statistics.unshaded_reads, 0u);
  EXPECT_NE(b.linear_rgba, none.linear_rgba) << "nothing came through";
  expect_unseen(a, b);
}

// A session keeps its plan from frame to frame, and the maps of a frame hold those of the frame before.
TEST(Cascade, ASessionDrawsWhatTheRendererDraws) {
  RenderSettings s = small_cascade();
  Session session(renderer(), {.frames_in_flight = 2});
  for (const std::array<double, 2> orbit : {std::array<double, 2>{0, 0}, {70, 10}, {200, -20}}) {
    s.camera.orbit_deg = orbit;
    SCOPED_TRACE(orbit[0]);
    expect_same_picture(renderer().render(head(), s), session.picture(session.draw(head(), s)));
  }
}

// The built-in head has so few texels per mm at 512 that no level is halved: three steps of wide terms, the
// last of which leaves its second axis to the sum of the narrow ones. The chain has a step per term.
TEST(Cascade, TakesHalfTheTexelsOfTheChain) {
  const RenderSettings chain = with_chain(unoptimised(small_settings("texture-space", 128, 512)));
  const Statistics a = renderer().render(head(), chain).statistics,
                   b = renderer().render(head(), with_cascade(chain)).statistics;
  EXPECT_EQ(b.irradiance_texels, a.irradiance_texels);
  EXPECT_EQ(a.launched, a.irradiance_texels + 6 * 2 * 512 * 512);
  EXPECT_EQ(b.launched, a.irradiance_texels + 6 * 512 * 512);
}

}  // namespace
}  // namespace dermis::tests
