// SPDX-License-Identifier: MIT
// Smaller maps for wide Gaussians: the picture stays, the work shrinks. A wide profile makes maps of 512
// texels halve three times.
#include <cmath>
#include <fstream>

#include "gpu/techniques/support.h"

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
    full.width = 192, full.height = 240;
    full.map_size = 512;
    full.profile = path;
    full.cull = full.depth = full.clip = false;
    progressive = full;
    progressive.maps = "progressive";
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
  s.profile = full.profile, s.map_size = 512, s.maps = "progressive";
  for (const double distance : {3.0, 12.0}) {
    s.distance = distance;
    const SkinRange skin = skin_range(renderer().render(*scan, s));
    EXPECT_GT(skin.pixels, 100u);
    EXPECT_GE(skin.low, 0.995) << distance;
    EXPECT_LE(skin.high, 1.005) << distance;
  }
}

TEST_F(Progressive, OptimisedItReadsNothingUnlit) {
  for (const std::array<double, 2> orbit : {std::array<double, 2>{0, 0}, {90, 10}, {200, -30}}) {
    RenderSettings s = progressive;
    s.orbit_deg = orbit;
    const Picture all = renderer().render(*scan, s);
    s.cull = s.depth = s.clip = true;
    const Picture optimised = renderer().render(*scan, s);
    EXPECT_EQ(optimised.statistics.unshaded_reads, 0u);
    EXPECT_LT(optimised.statistics.launched, all.statistics.launched);
    const Difference d = difference(all, optimised);
    EXPECT_LT(d.mean, 0.6) << orbit[0];
  }
}

TEST_F(Progressive, AllMasksMakeTheSamePicture) {
  progressive.cull = progressive.clip = true;
  progressive.orbit_deg = {40, 0};
  progressive.mask = "tiles";
  const Picture tiles = renderer().render(*scan, progressive);
  for (const char* mask : {"alpha", "depth"}) {
    progressive.mask = mask;
    EXPECT_EQ(renderer().render(*scan, progressive).linear_rgba, tiles.linear_rgba) << mask;
  }
}

// The maps of a far head halve less often than a near head's.
TEST_F(Progressive, AFarHeadKeepsItsPicture) {
  full.depth = progressive.depth = true;
  full.distance = progressive.distance = 12;
  const Difference d = difference(renderer().render(*scan, full), renderer().render(*scan, progressive));
  EXPECT_LE(d.largest, 14);
  EXPECT_LT(d.mean, 0.15);
}

TEST_F(Progressive, AnUnknownKindIsRefused) {
  progressive.maps = "pyramid";
  EXPECT_THROW(renderer().render(*scan, progressive), InputError);
}

}  // namespace
}  // namespace dermis::tests
