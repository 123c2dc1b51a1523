// SPDX-License-Identifier: MIT
// The statistics of a frame: complete, counted, the same from run to run.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "render/techniques/technique.h"

namespace dermis::tests {
namespace {

Statistics statistics_of(const std::string& technique, int map_size = 256, int heads = 1, int frames = 1) {
  RenderSettings s = small_settings(technique);
  s.quality.map_size = map_size;
  s.camera.heads = heads;
  s.output.frames = frames;
  return renderer().render(sphere(0.1), unoptimised(s)).statistics;
}

TEST(FrameStatistics, PassesAddUpToTheFrame) {
  for (const std::string& technique : technique_names()) {
    SCOPED_TRACE(technique);
    // One frame: medians over several need not add up to the median frame on a machine that does other work.
    const Statistics s = statistics_of(technique, 512, 1, 1);
    const double passes = std::accumulate(s.passes.begin(), s.passes.end(), 0.0,
                                          [](double t, const PassStatistics& p) { return t + p.ms; });
    EXPECT_EQ(s.frames, 1);
    EXPECT_GT(s.frame_ms_median, 0);
    EXPECT_NEAR(passes / s.frame_ms_median, 1, 0.1);
  }
}

TEST(FrameStatistics, TheMedianLiesBetweenTheExtremes) {
  const Statistics s = statistics_of("lambert", 256, 1, 4);
  EXPECT_EQ(s.frames, 4);
  EXPECT_LE(s.frame_ms_min, s.frame_ms_median);
  EXPECT_LE(s.frame_ms_median, s.frame_ms_max);
}

TEST(FrameStatistics, EveryPassHasANameOfItsOwn) {
  for (const std::string& technique : technique_names()) {
    SCOPED_TRACE(technique);
    std::vector<std::string> names;
    for (const PassStatistics& pass : statistics_of(technique, 256, 2).passes) names.push_back(pass.name);
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
    EXPECT_TRUE(std::find(names.begin(), names.end(), "") == names.end());
  }
}

TEST(FrameStatistics, PassesSayWhichImagesTheyWrite) {
  RenderSettings s = unoptimised(small_settings("texture-space", 96, 256));
  s.quality.shadow_size = 128;
  s.quality.samples = 1;
  const Statistics statistics = renderer().render(sphere(0.1), s).statistics;
  const auto pass = [&](const std::string& beginning) {
    const auto found = std::find_if(statistics.passes.begin(), statistics.passes.end(),
                                    [&](const PassStatistics& p) { return p.name.starts_with(beginning); });
    EXPECT_NE(found, statistics.passes.end()) << beginning;
    return found == statistics.passes.end() ? PassStatistics{} : *found;
  };
  // Layers of depth, 32 bits, at least one for each light; half floats, and beside them eight bits.
  EXPECT_EQ(pass("shadow").texels % (128u * 128u), 0u);
  EXPECT_GE(pass("shadow").texels, 128u * 128u * static_cast<unsigned>(statistics.lights));
  EXPECT_EQ(pass("shadow").image_bytes, 4 * pass("shadow").texels);
  EXPECT_EQ(pass("irradiance").texels % (256u * 256u), 0u);
  EXPECT_GE(pass("irradiance").image_bytes, 8u * 256u * 256u);
  EXPECT_EQ(pass("tone map").texels, 2 * 96u * 96u);
  EXPECT_EQ(pass("tone map").image_bytes, (8u + 4u) * 96u * 96u);
}

TEST(FrameStatistics, TexelsAreCounted) {
  const Statistics first = statistics_of("texture-space"), again = statistics_of("texture-space");
  EXPECT_EQ(first.irradiance_texels, again.irradiance_texels);
  EXPECT_EQ(first.convolved_texels, again.convolved_texels);
  EXPECT_EQ(first.launched, again.launched);
  // Six charts of (1/3 - 2 * 0.02)^2 of the map, packed 3 x 2; the upper bound leaves room for a border of
  // texels around each.
  const double side = 256 * (1.0 / 3 - 0.04), charts = 6 * side * (256 * (1.0 / 3 - 0.04));
  EXPECT_NEAR(static_cast<double>(first.irradiance_texels), charts, 0.1 * charts);
  EXPECT_EQ(first.gaussians, 6);
  EXPECT_EQ(first.convolved_texels, first.irradiance_texels * 6);
  EXPECT_GE(first.launched, first.convolved_texels);
  EXPECT_EQ(first.used_size, std::vector<int>{256});
}

TEST(FrameStatistics, CountsAreSummedOverHeads) {
  const Statistics one = statistics_of("texture-space", 256, 1),
                   three = statistics_of("texture-space", 256, 3);
  EXPECT_EQ(three.irradiance_texels, 3 * one.irradiance_texels);
  EXPECT_EQ(three.used_size, (std::vector<int>{256, 256, 256}));
  EXPECT_EQ(three.heads, 3);
}

TEST(FrameStatistics, SkinPixelsAreThoseOfThePicture) {
  for (const std::string& technique : technique_names()) {
    const Picture picture = renderer().render(sphere(0.1), small_settings(technique));
    std::uint64_t pixels = 0;
    for (std::size_t i = 3; i < picture.linear_rgba.size(); i += 4) pixels += picture.linear_rgba[i] >= 0.5f;
    EXPECT_NEAR(static_cast<double>(picture.statistics.skin_pixels), static_cast<double>(pixels),
                0.001 * static_cast<double>(pixels))
        << technique;
    EXPECT_GT(pixels, 5000u);
  }
}

// Others read these keys; more may be added.
TEST(FrameStatistics, JsonHasTheKeysThatAreAContract) {
  for (const std::string& technique : technique_names()) {
    SCOPED_TRACE(technique);
    const nlohmann::json j =
        nlohmann::json::parse(renderer().render(sphere(0.1), small_settings(technique)).statistics.json());

    for (const char* key : {"dermis", "device", "driver", "api", "technique", "timing"})
      EXPECT_TRUE(j.at(key).is_string() && j.at(key) != "") << key;
    for (const char* key :
         {"map_size", "heads", "lights", "gaussians", "load_ms", "pipeline_ms", "skin_pixels", "d_ref"})
      EXPECT_TRUE(j.at(key).is_number()) << key;
    for (const char* key : {"median", "min", "max", "frames"})
      EXPECT_TRUE(j.at("frame_ms").at(key).is_number()) << key;
    for (const char* key : {"irradiance", "convolved", "launched", "unshaded_reads", "transmission_misses"})
      EXPECT_TRUE(j.at("texels").at(key).is_number_unsigned()) << key;
    for (const char* key : {"images", "buffers", "peak"}) EXPECT_GT(j.at("memory_bytes").at(key), 0) << key;
    EXPECT_TRUE(j.at("texels").at("used_size").is_array());

    const bool has_maps = techniques::find_technique(technique).has_light_maps;
    EXPECT_EQ(j.at("optimise"),
              has_maps ? nlohmann::json({"cull", "depth", "clip"}) : nlohmann::json::array());
    EXPECT_EQ(j.at("mask").is_string(), has_maps);

    EXPECT_EQ(j.at("size"), nlohmann::json({128, 128}));
    EXPECT_EQ(j.at("skin_materials"), nlohmann::json({"skin"}));
    EXPECT_TRUE(j.at("distance").is_null());
    EXPECT_GT(j.at("d_ref"), 0);

    ASSERT_FALSE(j.at("passes").empty());
    for (const nlohmann::json& pass : j.at("passes"))
      EXPECT_TRUE(pass.at("name").is_string() && pass.at("ms").is_number() && pass.at("calls") == 1 &&
                  pass.at("texels").is_number_unsigned() && pass.at("image_bytes").is_number_unsigned());
    EXPECT_TRUE(j.at("timing") == "timestamp" || j.at("timing") == "submit");
  }
}

TEST(FrameStatistics, DistanceIsReportedWhenUsed) {
  RenderSettings s = small_settings("lambert");
  s.camera.distance = 5;
  EXPECT_EQ(nlohmann::json::parse(renderer().render(sphere(0.1), s).statistics.json()).at("distance"), 5.0);
}

}  // namespace
}  // namespace dermis::tests
