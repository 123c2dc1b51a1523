// SPDX-License-Identifier: MIT
#include "cli/compare_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace dermis::cli {
namespace {

using nlohmann::json;

image::Image8 grey(int width, int height, std::uint8_t value) {
  image::Image8 picture{
      .width = width,
      .height = height,
      .rgba = std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4), value)};
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

Compared display_pair(std::uint8_t a, std::uint8_t b) {
  Compared c{.a = "a<1>.png", .b = "b\xff.png", .shown_a = grey(30, 20, a), .shown_b = grey(30, 20, b)};
  c.found = image::compare(c.shown_a, c.shown_b);
  return c;
}

Compared linear_pair() {
  const auto flat = [](float value) {
    return image::ImageF{
        .width = 30, .height = 20, .channels = 3, .values = std::vector<float>(30 * 20 * 3, value)};
  };
  Compared c{.a = "a.exr", .b = "b.exr", .region_name = "region.png", .tone_map = "filmic"};
  c.region = image::Region(600);
  c.region[5] = 1;
  const image::ImageF variance = flat(0.01f);
  c.found = image::compare(flat(0.5f), flat(1), ToneMap::filmic, std::span(&variance, 1), c.region);
  c.shown_a = image::to_display(flat(0.5f), ToneMap::filmic);
  c.shown_b = image::to_display(flat(1), ToneMap::filmic);
  return c;
}

TEST(ComparePage, JsonOfDisplayPictures) {
  const Compared c = display_pair(40, 90);
  const json found = json::parse(compared_json(c));
  EXPECT_EQ(found.at("flip").at("mean"), c.found.flip.mean);
  for (const char* key : {"weighted_median", "q1", "q3", "min", "max"})
    EXPECT_GT(found.at("flip").at(key), 0) << key;
  EXPECT_EQ(found.at("psnr_db"), c.found.psnr_db);
  EXPECT_EQ(found.at("rel_mse"), c.found.rel_mse);
  EXPECT_EQ(found.at("size"), json({30, 20}));
  EXPECT_EQ(found.at("pixels"), 600);
  EXPECT_TRUE(found.at("region").is_null());
  for (const char* key : {"z", "tone_map", "exposures"}) EXPECT_FALSE(found.contains(key)) << key;
}

TEST(ComparePage, JsonOfLinearPictures) {
  const json found = json::parse(compared_json(linear_pair()));
  EXPECT_EQ(found.at("pixels"), 1);
  EXPECT_EQ(found.at("region"), "region.png");
  EXPECT_EQ(found.at("tone_map"), "filmic");
  EXPECT_EQ(found.at("exposures").at("count"), 2);
  EXPECT_EQ(found.at("z").at("beyond_2"), 1) << "0.5 is five standard errors";
  EXPECT_EQ(found.at("z").at("values"), 3);
}

TEST(ComparePage, TextForPeople) {
  const std::string text = compared_text(linear_pair());
  for (const char* part : {"A, the reference: a.exr", "1 of 600 compared (region.png)", "HDR-FLIP, mean",
                           "dB", "relative MSE", "beyond 3 standard errors", "tone map filmic"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_NE(compared_text(display_pair(40, 40)).find("100.00 dB"), std::string::npos);
}

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(ComparePage, PicturesAreInTheFileOnce) {
  const std::string page = compared_page(display_pair(40, 90));
  EXPECT_EQ(count(page, "src=\"data:image/png;base64,"), 4u) << "A, B and the map on two scales";
  EXPECT_EQ(count(page, "data-from=\"a\""), 1u);
  EXPECT_EQ(count(page, "data-from=\"b\""), 1u);
  EXPECT_EQ(count(page, "a<1>"), 0u) << "names of files are text, not HTML";
  EXPECT_EQ(count(page, "outside of the region"), 0u);
  EXPECT_EQ(count(compared_page(linear_pair()), "grey: outside of the region"), 2u);
  EXPECT_EQ(count(compared_page(display_pair(40, 40)), "src=\"data:"), 3u) << "no error: one scale";
}

TEST(ComparePage, AsksNothingOfTheNetwork) {
  for (const std::string& page : {compared_page(display_pair(40, 90)), compared_page(linear_pair())}) {
    EXPECT_EQ(count(page, "http://") + count(page, "https://") + count(page, "url(") + count(page, "@import"),
              0u);
    EXPECT_EQ(count(page, "src="), count(page, "src=\"data:")) << "every source is inside";
    EXPECT_EQ(count(page, "href="), count(page, "href=\"data:,\""));
  }
}

}  // namespace
}  // namespace dermis::cli
