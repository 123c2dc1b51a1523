// SPDX-License-Identifier: MIT
// Smaller maps for wide Gaussians: the picture stays, the work shrinks. A wide profile makes maps of 512
// texels halve three times.
#include <cmath>
#include <fstream>

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
    const std::string path = testing::TempDir() + "dermis_wide_profile.json";
    std::ofstream(path) << R"({"name": "wide", "variances_mm2": [0.5, 4, 16, 64, 250, 900],
      "weights": [[0.2, 0.3, 0.4], [0.2, 0.2, 0.2], [0.2, 0.2, 0.1],
        [0.1, 0.1, 0.1], [0.1, 0.1, 0.1], [0.2, 0.1, 0.1]]})";
    full = small_settings("texture-space");
    full.output.width = 192, full.output.height = 240;
    full.quality.map_size = 512;
    full.skin.profile = path;
    full = unoptimised(full);
    progressive = full;
    progressive.quality.maps = LightMaps::progressive;
  }
  RenderSettings full, progressive;
};

TEST_F(Progressive, TheSamePictureFromLessWork) {
  const Picture a = renderer().render(scan(), full), b = renderer().render(scan(), progressive);
  const DisplayDifference d = display_difference(a, b);
  RecordProperty("largest", d.largest);
  RecordProperty("mean", std::to_string(d.mean));
  EXPECT_LE(d.largest, 5);
  EXPECT_LT(d.mean, 0.15);
  EXPECT_GT(d.mean, 0) << "nothing was halved";
  EXPECT_EQ(a.statistics.irradiance_texels, b.statistics.irradiance_texels);
  EXPECT_LT(b.statistics.launched, 0.7 * static_cast<double>(a.statistics.launched));
  EXPECT_LT(b.statistics.convolved_texels, 0.7 * static_cast<double>(a.statistics.convolved_texels));
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
    s.camera.orbit_deg = orbit;
    const Picture all = renderer().render(scan(), s);
    s.quality.cull = s.quality.depth = s.quality.clip = true;
    const Picture optimised = renderer().render(scan(), s);
    EXPECT_EQ(optimised.statistics.unshaded_reads, 0u);
    EXPECT_LT(optimised.statistics.launched, all.statistics.launched);
    const DisplayDifference d = display_difference(all, optimised);
    EXPECT_LT(d.mean, 0.6) << orbit[0];
  }
}

TEST_F(Progressive, AllMasksMakeTheSamePicture) {
  progressive.quality.cull = progressive.quality.clip = true;
  progressive.camera.orbit_deg = {40, 0};
  progressive.quality.mask = BlurMask::tiles;
  const Picture tiles = renderer().render(scan(), progressive);
  for (const BlurMask mask : {BlurMask::alpha, BlurMask::depth}) {
    progressive.quality.mask = mask;
    SCOPED_TRACE(name_of(mask));
    expect_equal_bits(tiles, renderer().render(scan(), progressive));
  }
}

// The maps of a far head halve less often than a near head's.
TEST_F(Progressive, AFarHeadKeepsItsPicture) {
  full.quality.depth = progressive.quality.depth = true;
  full.camera.distance = progressive.camera.distance = 12;
  const DisplayDifference d =
      display_difference(renderer().render(scan(), full), renderer().render(scan(), progressive));
  EXPECT_LE(d.largest, 14);
  EXPECT_LT(d.mean, 0.15);
}

TEST_F(Progressive, AnUnknownKindIsRefused) {
  progressive.quality.maps = static_cast<LightMaps>(names_of<LightMaps>.size());
  EXPECT_THROW(renderer().render(scan(), progressive), InputError);
}

}  // namespace
}  // namespace dermis::tests
