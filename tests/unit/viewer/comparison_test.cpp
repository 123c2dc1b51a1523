// SPDX-License-Identifier: MIT
#include "viewer/model/comparison.h"
#include "support/made_results.h"

#include <gtest/gtest.h>

#include <limits>

#include "viewer/model/label_views.h"
#include "viewer/model/shown_maps.h"
#include "viewer/model/truth.h"

namespace dermis::viewer {
namespace {

Picture grey(int width, int height, std::uint8_t value) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.display_rgba.assign(4 * pixels, value);
  picture.linear_rgba.assign(4 * pixels, static_cast<float>(value) / 255);
  return picture;
}

TEST(Comparison, OfAPictureWithItselfIsNothing) {
  const Picture a = grey(24, 16, 100);
  const Comparison same = compare(a, a, {}, CompareMode::difference);
  ASSERT_EQ(same.regions.size(), 1u);
  EXPECT_EQ(same.regions[0].flip, 0);
  EXPECT_EQ(same.regions[0].psnr_db, 100);
  for (std::size_t i = 0; i < same.map_rgba.size(); ++i) EXPECT_EQ(same.map_rgba[i], i % 4 == 3 ? 255 : 0);
}

TEST(Comparison, CountsEachRegionByItself) {
  const Picture b = grey(40, 20, 100);
  Picture a = b;
  PictureRegion left{.name = "left", .mask = std::vector<std::uint8_t>(800, 0), .pixels = 400};
  PictureRegion none{.name = "none", .mask = std::vector<std::uint8_t>(800, 0), .pixels = 0};
  for (std::size_t y = 0; y < 20; ++y)
    for (std::size_t x = 0; x < 20; ++x) {
      left.mask[y * 40 + x] = 1;
      a.display_rgba[(y * 40 + x) * 4] = 110;
    }
  const Comparison both = compare(a, b, {left, none}, CompareMode::difference);
  ASSERT_EQ(both.regions.size(), 2u) << "an empty region has no figures";
  EXPECT_EQ(both.regions[1].name, "left");
  // One channel of three differs by 10, in all of it and in half of it.
  EXPECT_NEAR(both.regions[1].psnr_db, 32.9, 0.02);
  EXPECT_NEAR(both.regions[0].psnr_db, 32.9 + 3.01, 0.02);
  EXPECT_EQ(both.map_rgba[0], 40);
  EXPECT_EQ(both.map_rgba[4 * 39], 0);
  EXPECT_EQ(compare(a, b, {}, CompareMode::flip).map_rgba.size(), 4u * 800);
  EXPECT_TRUE(compare(a, b, {}, CompareMode::slider).map_rgba.empty());
}

TEST(Truth, HasSoManyPixelsAtMost) {
  for (const auto& [width, height] : {std::pair{100, 100}, {1280, 720}, {3840, 2160}, {321, 5000}}) {
    const int by = truth_divisor(width, height);
    EXPECT_LE((width / by) * (height / by), most_truth_pixels);
    if (by > 1) { EXPECT_GT((width / (by - 1)) * (height / (by - 1)), most_truth_pixels); }
  }
  RenderSettings settings;
  EXPECT_EQ(truth_settings(settings).output.bloom, 0);
}

TEST(ShownMaps, AreThoseOfTheRow) {
  const std::vector<std::string> names = shown_map_names(2, 3);
  EXPECT_EQ(names.front(), first_shown);
  for (const char* name : {"irradiance", "texel-density", "blur:0", "blur:1", "shadow:2"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_EQ(std::find(names.begin(), names.end(), "blur:2"), names.end());
}

TEST(PixelValues, AreThoseUnderThePointer) {
  Painted painted{.picture = grey(4, 2, 51)};
  painted.picture.display_rgba[4 * (1 * 4 + 2) + 1] = 200;
  painted.picture.statistics.used_size = {64};
  painted.picture.statistics.mapped_terms = {5};
  Results& labels = painted.labels.emplace();
  tests::give(labels, labels.instance, std::vector<std::uint32_t>(8, 1));
  tests::give(labels, labels.material, std::vector<std::uint32_t>(8, 2));
  tests::give(labels, labels.depth_m, std::vector<float>(8, 0.5f));
  tests::give(labels, labels.normal, std::vector<float>(24, 0));
  tests::give(labels, labels.uv, std::vector<float>(16, 0.25f));
  tests::give(labels, labels.region, std::vector<std::uint8_t>(8, Results::nose));
  tests::give(labels, labels.skin_mesh, std::vector<std::uint32_t>(8, 1));
  tests::give(labels, labels.unwrap, std::vector<float>(16, 0.25f));
  tests::give(labels, labels.thickness_mm, std::vector<float>(8, 4));

  const std::optional<PixelValues> pixel = pixel_at(painted, 0.6f, 0.9f);
  ASSERT_TRUE(pixel);
  EXPECT_EQ(pixel->x, 2);
  EXPECT_EQ(pixel->y, 1);
  EXPECT_EQ(pixel->display[1], 200);
  EXPECT_EQ(pixel->region, "nose");
  EXPECT_EQ(pixel->texel[0], 16);
  EXPECT_EQ(pixel->mapped_terms, 5);
  EXPECT_FALSE(pixel_at(painted, 1.0f, 0.5f));
  EXPECT_FALSE(pixel_at(painted, -0.1f, 0.5f));
}

TEST(LabelViews, HaveAColourForEachNumber) {
  Painted painted{.labels = Results{.width = 4, .height = 1}};
  Results& labels = *painted.labels;
  tests::give(labels, labels.instance, {0, 1, 1, 2});
  tests::give(labels, labels.material, {0, 1, 2, 1});
  tests::give(labels, labels.region, {0, 0, 1, 3});
  tests::give(labels, labels.depth_m, {std::numeric_limits<float>::infinity(), 1, 2, 3});
  tests::give(labels, labels.normal, {0, 0, 0, 0, 0, 1, 0, 1, 0, 1, 0, 0});
  tests::give(labels, labels.skin_mesh, {0, 1, 0, 1});
  tests::give(labels, labels.thickness_mm, {0, 2, 0, 9});

  const auto pixel = [&](std::string_view view, std::size_t i) {
    const std::vector<std::uint8_t> rgba = label_picture(painted, view);
    EXPECT_EQ(rgba.size(), 16u) << view;
    return rgba.size() == 16 ? std::array{rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]}
                             : std::array<std::uint8_t, 4>{};
  };
  for (const std::string_view view : label_views) {
    EXPECT_TRUE(is_label_view(view));
    EXPECT_EQ(pixel(view, 0), (std::array<std::uint8_t, 4>{0, 0, 0, 255})) << view;
  }
  EXPECT_EQ(pixel("instances", 1), pixel("instances", 2));
  EXPECT_NE(pixel("instances", 1), pixel("instances", 3));
  EXPECT_NE(pixel("materials", 1), pixel("materials", 2));
  EXPECT_NE(pixel("regions", 1), pixel("regions", 2));
  EXPECT_GT(pixel("depth", 1)[0], pixel("depth", 2)[0]);
  EXPECT_EQ(pixel("normals", 1), (std::array<std::uint8_t, 4>{128, 128, 255, 255}));

  EXPECT_FALSE(is_label_view("picture"));
  EXPECT_TRUE(label_picture(painted, "picture").empty());
  EXPECT_TRUE(label_picture({}, "regions").empty());
}

}  // namespace
}  // namespace dermis::viewer
