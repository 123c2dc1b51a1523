// SPDX-License-Identifier: MIT
// Smaller maps for wide Gaussians: the picture stays, the work shrinks. A wide profile makes maps of 512
// texels halve three times.
#include <cmath>
#include <fstream>

#include "gpu/techniques/support.h"
#include "settings/names.h"

namespace dermis::tests {
namespace {

class Progressive : public testing::Test {
 protected:
  void SetUp() override {
    const auto found =
        std::find_if(subjects().begin(), subjects().end(), [](const Subject& s) { return s.name == "scan"; });
    ASSERT_NE(found, subjects().end());
    if (!found->missing.empty()) GTEST_SKIP() << found->missing;
    static const Scene opened = found->open();
    scan = &opened;
    const std::string path = testing::TempDir() + "dermis_wide_profile.json";
    std::ofstream(path) << R"({"name": "wide", "variances_mm2": [0.5, 4, 16, 64, 250, 900],
      "weights": [[0.2, 0.3, 0.4], [0.2, 0.2, 0.2], [0.2, 0.2, 0.1],
        [0.1, 0.1, 0.1], [0.1, 0.1, 0.1], [0.2, 0.1, 0.1]]})";
    full = small_settings("texture-space");
    full.output.width = 192, full.output.height = 240;
    full.quality.map_size = 512;
    full.skin.profile = path;
    full.quality.cull = full.quality.depth = full.quality.clip = false;
    progressive = full;
    progressive.quality.maps = LightMaps::progressive;
  }
  const Scene* scan = nullptr;
  RenderSettings full, progressive;
};

// Largest and mean difference of display values over the picture.
struct Difference {
  int largest = 0;
  double mean = 0;
};
Difference difference(const Picture& a, const Picture& b) {
  Difference d;
  for (std::size_t i = 0; i < a.display_rgba.size(); ++i) {
    const int distance = std::abs(a.display_rgba[i] - b.display_rgba[i]);
    d.largest = std::max(d.largest, distance);
    d.mean += distance / static_cast<double>(a.display_rgba.size());
  }
  return d;
}

TEST_F(Progressive, TheSamePictureFromLessWork) {
  const Picture a = renderer().render(*scan, full), b = renderer().render(*scan, progressive);
  const Difference d = difference(a, b);
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
    const SkinRange skin = skin_range(renderer().render(*scan, s));
    EXPECT_GT(skin.pixels, 100u);
    EXPECT_GE(skin.low, 0.995) << distance;
    EXPECT_LE(skin.high, 1.005) << distance;
  }
}

TEST_F(Progressive, OptimisedItReadsNothingUnlit) {
  for (const std::array<double, 2> orbit : {std::array<double, 2>{0, 0}, {90, 10}, {200, -30}}) {
    RenderSettings s = progressive;
    s.camera.orbit_deg = orbit;
    const Picture all = renderer().render(*scan, s);
    s.quality.cull = s.quality.depth = s.quality.clip = true;
    const Picture optimised = renderer().render(*scan, s);
    EXPECT_EQ(optimised.statistics.unshaded_reads, 0u);
    EXPECT_LT(optimised.statistics.launched, all.statistics.launched);
    const Difference d = difference(all, optimised);
    EXPECT_LT(d.mean, 0.6) << orbit[0];
  }
}

TEST_F(Progressive, AllMasksMakeTheSamePicture) {
  progressive.quality.cull = progressive.quality.clip = true;
  progressive.camera.orbit_deg = {40, 0};
  progressive.quality.mask = BlurMask::tiles;
  const Picture tiles = renderer().render(*scan, progressive);
  for (const BlurMask mask : {BlurMask::alpha, BlurMask::depth}) {
    progressive.quality.mask = mask;
    EXPECT_EQ(renderer().render(*scan, progressive).linear_rgba, tiles.linear_rgba) << name_of(mask);
  }
}

// The maps of a far head halve less often than a near head's.
TEST_F(Progressive, AFarHeadKeepsItsPicture) {
  full.quality.depth = progressive.quality.depth = true;
  full.camera.distance = progressive.camera.distance = 12;
  const Difference d = difference(renderer().render(*scan, full), renderer().render(*scan, progressive));
  EXPECT_LE(d.largest, 14);
  EXPECT_LT(d.mean, 0.15);
}

TEST_F(Progressive, AnUnknownKindIsRefused) {
  progressive.quality.maps = static_cast<LightMaps>(names_of<LightMaps>.size());
  EXPECT_THROW(renderer().render(*scan, progressive), InputError);
}

}  // namespace
}  // namespace dermis::tests
