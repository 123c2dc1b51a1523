// SPDX-License-Identifier: MIT
// Labels as colours, and what is known of one pixel.
#include "viewer/model/label_views.h"
#include "support/made_results.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/viewer/documents.h"
#include "viewer/model/camera_moves.h"
#include "viewer/model/shown_maps.h"

namespace dermis::viewer {
namespace {

/// Nothing, a sheet that is no skin, an ear and a cheek, side by side.
Painted four_pixels() {
  Painted painted;
  Picture& picture = painted.picture;
  picture.width = 4;
  picture.height = 1;
  picture.linear_rgba.assign(16, 0.5f);
  picture.display_rgba.assign(16, 128);
  picture.statistics.heads = 1;
  picture.statistics.used_size = {4};
  Results& labels = painted.labels.emplace(Results{.width = 4, .height = 1});
  tests::give(labels, labels.instance, {0, 1, 1, 1});
  tests::give(labels, labels.material, {0, 2, 1, 1});
  tests::give(labels, labels.depth_m, {INFINITY, 1, 1, 1});
  tests::give(labels, labels.normal, std::vector<float>(12));
  tests::give(labels, labels.uv, std::vector<float>(8));
  tests::give(labels, labels.motion_px, std::vector<float>(8));
  tests::give(labels, labels.region,
              {Results::no_region, Results::no_region, Results::ear, Results::other_skin});
  tests::give(labels, labels.skin_mesh, {0, 0, 1, 1});
  tests::give(labels, labels.unwrap, {0, 0, 0, 0, 0.3f, 0.8f, 1, 1});
  tests::give(labels, labels.thickness_mm, {0, 0, 3, 24});
  return painted;
}

std::array<float, 3> pixel_of(const std::vector<std::uint8_t>& rgba, std::size_t i) {
  return {static_cast<float>(rgba[4 * i]) / 255, static_cast<float>(rgba[4 * i + 1]) / 255,
          static_cast<float>(rgba[4 * i + 2]) / 255};
}

TEST(LabelViews, ThicknessHasTheColoursOfItsLegend) {
  const Painted painted = four_pixels();
  const std::vector<std::uint8_t> rgba = label_picture(painted, "thickness");
  ASSERT_EQ(rgba.size(), 16u);
  EXPECT_EQ(pixel_of(rgba, 0), (std::array<float, 3>{0, 0, 0}));
  EXPECT_NE(pixel_of(rgba, 1), pixel_of(rgba, 2)) << "grey is no thickness";

  const std::vector<LegendMark> legend = thickness_legend(painted);
  std::vector<float> marks_mm;
  for (const LegendMark& mark : legend) marks_mm.push_back(mark.mm);
  EXPECT_EQ(marks_mm, (std::vector<float>{1, 2, 5, 10, 20, 24}));
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(pixel_of(rgba, 3)[c], legend.back().colour[c], 1.0 / 255) << "the thickest";
  // Of 3 mm: between the marks beside it.
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_LT(pixel_of(rgba, 2)[c], legend[1].colour[c]);
    EXPECT_GT(pixel_of(rgba, 2)[c], legend[2].colour[c]);
  }
}

TEST(LabelViews, HaveNoLegendWithoutSkin) {
  Painted painted = four_pixels();
  std::ranges::fill(painted.labels->thickness_mm, 0.0f);
  EXPECT_TRUE(thickness_legend(painted).empty());
  painted.labels.reset();
  EXPECT_TRUE(thickness_legend(painted).empty());
  EXPECT_TRUE(label_picture(painted, "thickness").empty());
}

TEST(Loupe, SaysWhereThePointLies) {
  Painted painted = four_pixels();
  const float u = 2.5f / 4;
  EXPECT_FALSE(pixel_at(painted, u, 0.5f)->position_m) << "by which camera?";

  const Document document = tests::square_document();
  painted.camera = drawn_camera(document.scene, document.settings);
  const PixelValues ear = *pixel_at(painted, u, 0.5f);
  ASSERT_TRUE(ear.position_m);
  const std::array<double, 3> eye_m = camera_place(document).eye_m;  // looks along -Z
  EXPECT_GT(ear.position_m->at(0), eye_m[0]);
  EXPECT_NEAR(ear.position_m->at(1), eye_m[1], 1e-5);
  EXPECT_NEAR(ear.position_m->at(2), eye_m[2] - 1, 1e-5);
  EXPECT_FALSE(pixel_at(painted, 0.5f / 4, 0.5f)->position_m) << "nothing is there";
}

TEST(Loupe, SaysTexelThicknessAndIrradiance) {
  Painted painted = four_pixels();
  const float u = 2.5f / 4;
  ASSERT_TRUE(pixel_at(painted, u, 0.5f));
  EXPECT_FALSE(pixel_at(painted, u, 0.5f)->irradiance) << "no map";

  painted.light = LightMap{.side = 4, .rgba = std::vector<float>(64), .exposure_ev = 1};
  const std::size_t at = 4 * (3 * 4 + 1);  // texel 1.2, 3.2
  for (std::size_t c = 0; c < 4; ++c) painted.light->rgba[at + c] = static_cast<float>(c + 1);
  const PixelValues ear = *pixel_at(painted, u, 0.5f);
  EXPECT_EQ(ear.region, "ear");
  EXPECT_EQ(ear.thickness_mm, 3);
  EXPECT_NEAR(ear.texel[0], 1.2, 1e-6);
  EXPECT_NEAR(ear.texel[1], 3.2, 1e-6);
  ASSERT_TRUE(ear.irradiance);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(ear.irradiance->at(c), std::numbers::pi * static_cast<double>(c + 1) / 2, 1e-5);

  EXPECT_FALSE(pixel_at(painted, 3.5f / 4, 0.5f)->irradiance) << "that texel was not lit";
  EXPECT_FALSE(pixel_at(painted, 1.5f / 4, 0.5f)->irradiance) << "no skin";
  painted.picture.statistics.heads = 2;
  EXPECT_FALSE(pixel_at(painted, u, 0.5f)->irradiance) << "of which head is the map?";
}

}  // namespace
}  // namespace dermis::viewer
