// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/scene_comparison.h"

namespace dermis::cli {
namespace {

using nlohmann::json;

/// Two regions, one of them empty; two techniques; 4 x 2 pixels.
SceneComparison made_up() {
  SceneComparison c;
  c.scene = "head <1>.gltf";
  c.tone_map = "filmic";
  c.model = "bssrdf";
  c.samples = 64;
  c.noise_percent = 1.5;
  c.reference_seconds = 2;
  c.width = 4;
  c.height = 2;
  c.supersample = 4;
  c.regions = {{"skin", {1, 1, 1, 1, 0, 0, 0, 0}, 4},
               {"nose", {1, 0, 0, 0, 0, 0, 0, 0}, 1},
               {"ears", std::vector<std::uint8_t>(8), 0}};

  const auto picture = [](std::uint8_t value) {
    std::vector<std::uint8_t> rgba(32, value);
    for (std::size_t i = 3; i < 32; i += 4) rgba[i] = 255;
    return rgba;
  };
  c.reference_display = picture(100);

  for (const char* name : {"texture-space", "lambert"}) {
    ComparedTechnique t;
    t.name = name;
    t.statistics.technique = name;
    t.statistics.frame_ms_median = 12.34;
    t.statistics.gaussians = t.name == "lambert" ? 0 : 6;
    t.statistics.optimise = {"cull"};

    t.errors = {RegionError{.flip = 0.02,
                            .hdr_flip = 0.03,
                            .psnr_db = 40,
                            .rel_mse = 1e-3,
                            .rel_mse_unbiased = 9e-4,
                            .share = 1},
                RegionError{.flip = 0.04,
                            .hdr_flip = 0.05,
                            .psnr_db = 35,
                            .rel_mse = 2e-3,
                            .rel_mse_unbiased = {},
                            .share = 0.5},
                std::nullopt};
    t.display_rgba = picture(120);
    t.flip = std::vector<float>(8, 0.1f);
    c.techniques.push_back(t);
  }

  c.noise = c.techniques.front().errors;
  return c;
}

TEST(SceneComparisonPage, Json) {
  const json j = json::parse(scene_comparison_json(made_up()));
  EXPECT_EQ(j.at("scene"), "head <1>.gltf");
  EXPECT_EQ(j.at("regions")[2], json({{"name", "ears"}, {"pixels", 0}}));

  const json& first = j.at("techniques")[0];
  EXPECT_EQ(first.at("frame_ms").at("median"), 12.34);
  EXPECT_EQ(first.at("optimise"), json::array({"cull"}));
  EXPECT_EQ(first.at("error").at("skin").at("flip"), 0.02);
  EXPECT_EQ(first.at("error").at("nose").at("share"), 0.5);
  EXPECT_TRUE(first.at("error").at("nose").at("rel_mse_unbiased").is_null());
  EXPECT_TRUE(first.at("error").at("ears").is_null());

  EXPECT_EQ(j.at("noise").at("skin").at("psnr_db"), 40);
  EXPECT_EQ(j.at("reference").at("samples"), 64);

  SceneComparison c = made_up();
  c.reference_file = "truth.exr";
  c.noise.reset();
  const json given = json::parse(scene_comparison_json(c));
  EXPECT_EQ(given.at("reference"), json({{"file", "truth.exr"}}));
  EXPECT_TRUE(given.at("noise").is_null());
}

TEST(SceneComparisonPage, TextHasATablePerRegion) {
  const std::string text = scene_comparison_text(made_up());
  for (const char* part : {"skin: 4 pixels", "nose: 1 pixels", "ears: empty", "lambert", "12.3", "50 %",
                           "0.0200", "40.00", "noise of the reference"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

TEST(SceneComparisonPage, PageHasASliderAndAMapOfErrorsForEachTechnique) {
  const std::string page = scene_comparison_page(made_up());
  const auto count = [&](const std::string& what) {
    int found = 0;
    for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_EQ(count("class=\"slider\""), 2);
  EXPECT_EQ(count("id=\"technique-1-error\""), 1);
  EXPECT_EQ(count("id=\"region-1\""), 1);
  EXPECT_EQ(count("id=\"region-2\""), 0) << "an empty region has no picture";
  EXPECT_EQ(count("<table class=\"grid\">"), 2) << "nor a table";
  EXPECT_NE(page.find("head &lt;1&gt;.gltf"), std::string::npos);
  EXPECT_EQ(page.find("<1>"), std::string::npos);
}

}  // namespace
}  // namespace dermis::cli
