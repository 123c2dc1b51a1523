// SPDX-License-Identifier: MIT
// Techniques over heads and distances: what is said about them.
#include "cli/bench/technique_grid.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace dermis::cli::bench {
namespace {

Measured column(const std::string& name, bool has_light_maps, double shared_ms, double view_ms,
                std::uint64_t skin_pixels) {
  const double ms = shared_ms + view_ms;
  Measured m{.variant = {name, name, "", {}}, .rounds_ms = {ms + 1, ms, ms - 1}, .passes = {}, .counts = {}};
  m.variant.settings.technique = m.counts.technique = name;
  // A blur of light maps belongs to all views, one in the picture to its view.
  m.passes = {{.name = has_light_maps ? "blur 0 u" : "shadow", .ms = shared_ms, .calls = 1},
              {.name = has_light_maps ? "final" : "separable 1", .ms = view_ms, .calls = 1}};
  m.counts.irradiance_texels = has_light_maps ? 1 : 0;
  m.counts.skin_pixels = skin_pixels;
  return m;
}

/// One head: light maps 20 ms and 10 ms per view, or 25 ms per view. Nine heads: the same maps nine times.
Run two_techniques() {
  Run run{.version = "1", .commit = "c", .command = "dermis bench", .scene = "<head>"};
  run.settings.output.width = 100, run.settings.output.height = 100;
  run.rounds = 3;
  run.cells.push_back(
      {.heads = 1,
       .distance = 2.5,
       .measured = {column("maps", true, 20, 10, 5000), column("picture", false, 2, 23, 5000)},
       .differences = {}});
  run.cells.push_back({.heads = 9,
                       .distance = 10,
                       .measured = {column("maps", true, 4, 10, 9000), column("picture", false, 2, 30, 9000)},
                       .differences = {}});
  return run;
}

TEST(TechniqueGrid, SharesWhatDoesNotDependOnTheEye) {
  const bench::Run run = two_techniques();
  const ViewCost maps = view_cost(run.cells[0].measured[0]), picture = view_cost(run.cells[0].measured[1]);
  EXPECT_EQ(maps.shared_ms, 20);
  EXPECT_EQ(maps.per_view_ms, 10);
  EXPECT_EQ(picture.shared_ms, 2);
  EXPECT_EQ(picture.per_view_ms, 23);
  EXPECT_EQ(maps.of(2), 40);
  EXPECT_EQ(coverage_of(run.cells[0], run.settings), 0.5);
}

TEST(TechniqueGrid, SaysWhereOneOvertakesTheOther) {
  const std::vector<std::string> sentences = crossovers(two_techniques());
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(
      sentences[0].find("maps against picture: faster in 1 of 2 cells (9 heads at 10 radii, 90.0 % skin)"),
      std::string::npos)
      << sentences[0];
  EXPECT_NE(sentences[0].find("slower at 50.0 to 50.0 %"), std::string::npos) << sentences[0];
  // 20 + 2 * 10 < 2 + 2 * 23, if both eyes share the maps.
  EXPECT_NE(sentences[0].find("2 views of 1 head"), std::string::npos) << sentences[0];
  EXPECT_TRUE(crossovers(bench::Run{}).empty());
}

TEST(TechniqueGrid, TakesTheFastestColumnOfTheFirstTechnique) {
  bench::Run run = two_techniques();
  for (Cell& cell : run.cells) {
    Measured better = column("maps", "progressive", 1, 2, 5000);
    better.variant.key = better.variant.heading = "maps compute";
    cell.measured.push_back(std::move(better));
  }
  const std::vector<std::string> sentences = crossovers(run);
  ASSERT_EQ(sentences.size(), 1u) << "not against itself";
  EXPECT_NE(sentences[0].find("maps against picture: faster in 2 of 2 cells"), std::string::npos)
      << sentences[0];
}

TEST(TechniqueGrid, SaysWhatScatteringCosts) {
  bench::Run run = two_techniques();
  for (Cell& cell : run.cells) cell.measured.push_back(column("lambert", false, 2, 16, 5000));
  const std::string line = technique_grid_line(run.cells[0], run.settings);
  EXPECT_NE(line.find("30 (+12)"), std::string::npos) << line;
  EXPECT_NE(line.find("25 (+7)"), std::string::npos) << line;
  EXPECT_EQ(line.find("18 ("), std::string::npos) << line;
  const auto json = nlohmann::json::parse(technique_grid_json(run));
  EXPECT_EQ(json.at("cells")[0].at("variants").at("maps").at("minus_lambert_ms"), 12);
  const auto without = nlohmann::json::parse(technique_grid_json(two_techniques()));
  EXPECT_FALSE(without.at("cells")[0].at("variants").at("maps").contains("minus_lambert_ms"));
}

TEST(TechniqueGrid, JsonAndPageHaveEveryColumn) {
  const bench::Run run = two_techniques();
  const auto json = nlohmann::json::parse(technique_grid_json(run));
  EXPECT_EQ(json.at("cells").size(), 2u);
  EXPECT_EQ(json.at("cells")[0].at("coverage"), 0.5);
  EXPECT_EQ(json.at("cells")[0].at("maps_ms"), 30);
  EXPECT_EQ(json.at("cells")[1].at("variants").at("picture").at("rounds_ms").size(), 3u);
  EXPECT_EQ(json.at("cells")[0].at("variants").at("maps").at("shared_by_views_ms"), 20);

  const std::string page = technique_grid_page(run);
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_NE(page.find("&lt;head&gt;"), std::string::npos);
  EXPECT_EQ(page.find("<head>.glb"), std::string::npos);
  EXPECT_NE(page.find("9 heads"), std::string::npos);
}

}  // namespace
}  // namespace dermis::cli::bench
