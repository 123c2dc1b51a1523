// SPDX-License-Identifier: MIT
// Smaller maps for wide Gaussians: the picture stays, the work shrinks. A wide profile makes maps of 512
// texels halve three times.
#include <cmath>

#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "settings/names.h"

namespace dermis::tests {
namespace {

class Progressive : public WithScan {
 protected:
  void SetUp() override {
    WithScan::SetUp();
    full = with_profile(small_settings("texture-space"), "wide",
                        {{.variance_mm2 = 0.5, .weight = {0.2, 0.3, 0.4}},
                         {.variance_mm2 = 4, .weight = {0.2, 0.2, 0.2}},
                         {.variance_mm2 = 16, .weight = {0.2, 0.2, 0.1}},
                         {.variance_mm2 = 64, .weight = {0.1, 0.1, 0.1}},
                         {.variance_mm2 = 250, .weight = {0.1, 0.1, 0.1}},
                         {.variance_mm2 = 900, .weight = {0.2, 0.1, 0.1}}});
    full.output.width = 192, full.output.height = 240;
    full.quality.map_size = 512;
    full = unoptimised(full);
    progressive = full;
    progressive.quality.maps = LightMaps::progressive;
  }
  RenderSettings full, progressive;
};

TEST_F(Progressive, TheSamePictureFromLessWork) {
  const Picture a = renderer().render(scan(), full), b = renderer().render(scan(), progressive);
  expect_unseen(a, b);
  EXPECT_NE(a.linear_rgba, b.linear_rgba) << "nothing was halved";
  EXPECT_EQ(a.statistics.irradiance_texels, b.statistics.irradiance_texels);

  // The scan has so many texels per mm that the six terms lie on maps halved 0, 0, 0, 1, 2 and 3 times
  // (passes::map_halvings()); the widest step of the first three takes two. Each step is one convolution
  // along each axis, and each smaller map is downsampled to once.
  const std::uint64_t lit = a.statistics.irradiance_texels, map = 512 * 512,
                      halved = map / 4 + map / 16 + map / 64;
  EXPECT_EQ(a.statistics.launched, lit + 2 * 7 * map);
  EXPECT_EQ(b.statistics.launched, lit + 2 * (4 * map + halved) + halved);
  // A texel of a smaller map takes part if one of those that it covers is lit.
  EXPECT_LE(b.statistics.convolved_texels, 3 * lit + halved);
  EXPECT_GE(b.statistics.convolved_texels, 3 * lit + lit / 4 + lit / 16 + lit / 64);
  EXPECT_EQ(a.statistics.maps, "full");
  EXPECT_EQ(b.statistics.maps, "progressive");
}

TEST_F(Progressive, WhiteStaysWhite) {
  RenderSettings s = furnace_settings("texture-space", false);
  s.skin.profile = full.skin.profile, s.quality.map_size = 512, s.quality.maps = LightMaps::progressive;
  for (const double distance : {3.0, 12.0}) {
    s.camera.distance = distance;
    const SkinRange skin = skin_range(renderer().render(scan(), s));
    EXPECT_GT(skin.pixels, 100u);
    EXPECT_GE(skin.low, 0.995) << distance;
    EXPECT_LE(skin.high, 1.005) << distance;
  }
}

TEST_F(Progressive, OptimisedItReadsNothingUnlit) {
  for (const std::array<double, 2> orbit : {std::array<double, 2>{0, 0}, {90, 10}, {200, -30}}) {
    RenderSettings s = progressive;
    s.output.width = 64, s.output.height = 80;
    s = super_sampled(s, 4);
    s.camera.orbit_deg = orbit;
    const Picture all = renderer().render(scan(), s);
    s.quality.cull = s.quality.depth = s.quality.clip = true;
    const Picture optimised = renderer().render(scan(), s);
    EXPECT_EQ(optimised.statistics.unshaded_reads, 0u);
    EXPECT_LT(optimised.statistics.launched, all.statistics.launched);
    SCOPED_TRACE(orbit[0]);
    expect_unseen(downsampled(all, 4), downsampled(optimised, 4));
  }
}

// The maps of a far head halve less often than a near head's.
TEST_F(Progressive, AFarHeadKeepsItsPicture) {
  full.quality.depth = progressive.quality.depth = true;
  full.camera.distance = progressive.camera.distance = 12;
  expect_unseen(renderer().render(scan(), full), renderer().render(scan(), progressive));
}

TEST_F(Progressive, AnUnknownKindIsRefused) {
  progressive.quality.maps = static_cast<LightMaps>(names_of<LightMaps>.size());
  EXPECT_THROW(renderer().render(scan(), progressive), InputError);
}

}  // namespace
}  // namespace dermis::tests
