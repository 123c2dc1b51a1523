// SPDX-License-Identifier: MIT
// What a table of techniques says, from figures that are made up.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/comparison/table.h"

namespace dermis::cli::comparison {
namespace {

std::vector<std::uint8_t> grey(std::uint8_t value) {
  return {value, value, value, 255, value, value, value, 255};
}

ComparedTechnique technique(const std::string& name, double ms, double rel_mse, double noise = 1e-5) {
  ComparedTechnique t;
  t.name = name;
  t.statistics.technique = name.substr(0, name.find(','));
  t.statistics.frame_ms_median = ms;
  t.statistics.skin_pixels = 100;
  t.statistics.light_reads = 5000;
  t.statistics.image_bytes = 3'000'000;
  t.errors = {RegionError{.flip = 0.02,
                          .hdr_flip = 0.03,
                          .psnr_db = 40,
                          .rel_mse = rel_mse + noise,
                          .rel_mse_unbiased = rel_mse,
                          .share = 1}};
  t.display_rgba = grey(90);
  t.flip = {0.1f, 0.2f};
  return t;
}

Case case_of(const std::string& name, std::vector<ComparedTechnique> techniques) {
  Case one{.name = name, .shows = {}, .found = {}};
  one.found.scene = "head <1>";
  one.found.width = 2, one.found.height = 1;
  one.found.regions = {{"skin", {1, 1}, 2}};
  one.found.reference_display = grey(100);
  one.found.techniques = std::move(techniques);
  return one;
}

Table made_up_table() {
  Table table{.scene = "head <1>", .settings = {}, .cases = {}};
  table.cases.push_back(
      case_of("near", {technique("maps", 100, 1e-4), technique("blur", 60, 4e-4),
                       technique("none", 20, 40e-4), technique("maps, one Gaussian", 1, 1e-6)}));
  table.cases.push_back(case_of(
      "far", {technique("maps", 50, 1e-4), technique("blur", 30, 1.1e-4), technique("none", 40, 9e-4)}));
  table.cases.back().is_test = true;
  return table;
}

TEST(ComparisonTable, NamesTheRightChoiceOfEachCaseAlsoWhereItIsAnother) {
  const std::vector<std::string> sentences = verdict(made_up_table());
  ASSERT_EQ(sentences.size(), 5u) << "two cases, three techniques";
  EXPECT_EQ(sentences[0],
            "near: maps is nearest (relMSE 0.0001, 100 ms); blur takes 0.60 of the time of maps and has 2 "
            "times its "
            "error, none takes 0.20 of the time of maps and has 6.3 times its error.");
  EXPECT_EQ(
      sentences[1],
      "far: maps is nearest (relMSE 0.0001, 50 ms); blur is as near within 25 %, and takes 0.60 of its time; "
      "nothing is faster without being beaten.");
  EXPECT_EQ(
      sentences[2],
      "maps is the right choice in 1 of 2 cases (near); nothing is both faster and nearer in any case.");
  EXPECT_EQ(sentences[3],
            "blur is the right choice in 1 of 2 cases (far); nothing is both faster and nearer in any case.");
  EXPECT_EQ(sentences[4],
            "none is the right choice in no case; something is both faster and nearer in 1 (far).");
}

TEST(ComparisonTable, AnErrorBelowTheNoiseIsNoErrorOfNothing) {
  const Figures f = figures_of(technique("maps", 10, -3e-6, 1e-4));
  EXPECT_NEAR(f.rel_mse, 1e-6, 1e-12);
  EXPECT_EQ(f.taps_per_pixel, 50);
  EXPECT_EQ(f.device_mb, 3);
}

// Of the time that it took, not of a larger picture.
TEST(ComparisonTable, JudgesByThePictureAtItsSize) {
  ComparedTechnique t = technique("blur", 10, 1e-4);
  EXPECT_EQ(figures_of(t).rel_mse, figures_of(t).larger);
  t.at_size = technique("blur", 10, 7e-4).errors.front();
  EXPECT_NEAR(figures_of(t).rel_mse, 7e-4, 1e-12);
  EXPECT_NEAR(figures_of(t).larger, 1e-4, 1e-12);
}

TEST(ComparisonTable, TextJsonAndPageHaveEveryCase) {
  const Table table = made_up_table();
  const std::string text = table_text(table);
  for (const char* part :
       {"head <1>: 2 cases", "near", "far", "maps, one Gaussian", "0.0001 / 0.0200", "0.00011", "50 / 3"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;

  const auto json = nlohmann::json::parse(table_json(table));
  ASSERT_EQ(json.at("cases").size(), 2u);
  EXPECT_EQ(json.at("cases")[1].at("name"), "far");
  EXPECT_EQ(json.at("cases")[0].at("comparison").at("techniques")[1].at("taps_per_pixel"), 50);
  EXPECT_EQ(json.at("verdict").size(), 5u);

  const std::string page = table_page(table);
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_EQ(page.find("<1>"), std::string::npos);
  // Pictures of both cases have names of their own.
  for (const char* id : {"id=\"case-0-technique-0\"", "id=\"case-1-technique-0\"", "id=\"case-1\""})
    EXPECT_NE(page.find(id), std::string::npos) << id;
  for (const char* part : {"Sizes and distances", "Test scenes", "<circle"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace dermis::cli::comparison
