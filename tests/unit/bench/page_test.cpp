// SPDX-License-Identifier: MIT
// A run as JSON, as text and as a page.
#include "cli/bench/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "unit/bench/made_up.h"

namespace dermis::cli::bench {
namespace {

using nlohmann::json;
using tests::made_up_run;
using tests::made_up_run_with_pictures;

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Variants, DifferInNothingButWhatTheyAreFor) {
  RenderSettings s;
  s.quality.map_size = 777;
  s.camera.heads = 5;
  s.lighting.rig_lights = 3;

  for (const Variant& v : variants_of(s)) {
    SCOPED_TRACE(v.key);
    EXPECT_EQ(v.settings.quality.map_size, 777);
    EXPECT_EQ(v.settings.camera.heads, 5);
    EXPECT_EQ(v.settings.lighting.rig_lights, 3);
    EXPECT_EQ(v.settings.quality.samples, s.quality.samples);
    const bool floor = v.key == floor_key;
    const bool beyond = v.key == compute_key || v.key == still_key;
    EXPECT_EQ(v.settings.technique, floor ? "lambert" : beyond ? "texture-space" : "published");
    EXPECT_EQ(v.settings.quality.skip_unseen_heads, v.key != baseline_key);

    const bool compute = v.key == compute_key || v.key == still_key,
               all = v.key == optimised_key || v.key == at_edge_key || compute;
    EXPECT_EQ(v.settings.quality.keep_shadows, v.key == still_key);
    EXPECT_EQ(v.settings.quality.cull, all || v.key == "cull");
    EXPECT_EQ(v.settings.quality.depth, all || v.key == "depth");
    EXPECT_EQ(v.settings.quality.clip, all || v.key == "clip");
    EXPECT_EQ(v.settings.quality.clip_margin_mm, v.key == at_edge_key ? std::optional(0.0) : std::nullopt);
  }

  EXPECT_EQ(variants_of(s).size(), 10u);
  s.quality.clip_margin_mm = 0;
  EXPECT_EQ(variants_of(s).size(), 9u) << "all is at the edge already";
}

// Other programs read these; more may be added.
TEST(RunJson, KeysThatAreAContract) {
  const json j = json::parse(run_json(made_up_run()));
  EXPECT_EQ(j.at("device"), "a device");
  EXPECT_EQ(j.at("command"), "dermis bench <head>.glb");
  EXPECT_EQ(j.at("commit"), "abcdef0");
  EXPECT_EQ(j.at("dermis"), "1.2.3");
  ASSERT_EQ(j.at("cells").size(), 4u);

  for (const json& cell : j.at("cells")) {
    for (const char* key : {"heads", "distance", "baseline_ms", "skip_ms", "cull_ms", "depth_ms", "clip_ms",
                            "all_ms", "lambert_ms", "speedup", "speedup_over_skip", "speedup_margin_0"})
      EXPECT_TRUE(cell.at(key).is_number()) << key;
    EXPECT_NEAR(cell.at("speedup"), cell.at("baseline_ms").get<double>() / cell.at("all_ms").get<double>(),
                1e-12);
    EXPECT_NEAR(cell.at("speedup_over_skip"),
                cell.at("skip_ms").get<double>() / cell.at("all_ms").get<double>(), 1e-12);

    EXPECT_EQ(cell.at("texels").at("all").at("irradiance"), 100);
    EXPECT_FALSE(cell.at("texels").contains("lambert"));
    EXPECT_EQ(cell.at("variants").at("cull").at("rounds_ms").size(), 3u);
    EXPECT_EQ(cell.at("variants").at("cull").at("passes").at(0).at("name"), "shadow");
  }

  const json& first = j.at("cells")[0];
  EXPECT_EQ(first.at("baseline_ms"), 40);
  EXPECT_EQ(first.at("speedup"), 2);
  EXPECT_EQ(first.at("paper_speedup"), 1.17);
  EXPECT_EQ(first.at("psnr_db"), 45.5);
  EXPECT_EQ(first.at("flip_mean"), 0.0125);

  const json& second = j.at("cells")[1];
  EXPECT_TRUE(second.at("paper_speedup").is_null()) << "the paper has no 7 radii";
  EXPECT_TRUE(second.at("psnr_db").is_null());
  EXPECT_TRUE(j.at("cells")[2].at("paper_speedup").is_null()) << "the paper has no 3 heads";
}

TEST(RunTable, OursNextToThePapers) {
  const bench::Run run = made_up_run();
  EXPECT_NE(paper_table(run).find("2.00 (1.17)"), std::string::npos) << paper_table(run);
  EXPECT_NE(paper_table(run).find("2.00 (-)"), std::string::npos);
  EXPECT_NE(paper_table(run).find("6.00 (-)"), std::string::npos);
  const std::string line = table_line(run.cells.front());
  for (const char* part : {"2.00", "1.90", "1.17", "1.54", "0.77", "45.50", "0.0125", " 64\n"})
    EXPECT_NE(line.find(part), std::string::npos) << part << line;
  // Headings stand over their columns: bars of both at the same places.
  const std::string head = table_head(run), headings = head.substr(head.rfind('\n', head.size() - 2) + 1);
  for (std::size_t at = line.find('|'); at != std::string::npos; at = line.find('|', at + 1))
    EXPECT_EQ(headings.at(at), '|') << headings << line;
  EXPECT_EQ(count(line, "|"), count(headings, "|"));
}

TEST(RunPage, HoldsEveryCell) {
  const std::string page = run_page(made_up_run_with_pictures());
  EXPECT_EQ(count(page, "of display values (tone map natural)"), 1u);
  EXPECT_EQ(count(page, "<h3>"), 4u);
  EXPECT_EQ(count(page, "class=\"slider\""), 4u);
  EXPECT_EQ(count(page, "src=\"data:image/png;base64,"), 2 * 4 + 3u);
  EXPECT_EQ(count(page, "<svg"), count(page, "</svg>"));
  EXPECT_EQ(count(page, "class=\"chart\""), 2 + 2 + 4u) << "against heads, against distance, bars";

  EXPECT_NE(page.find("abcdef0"), std::string::npos);
  EXPECT_EQ(count(page, "<head>.glb"), 0u) << "names of files are text, not HTML";
  EXPECT_EQ(count(page, ">nan<") + count(page, ">inf<"), 0u);

  // Each half of a slider names a picture of its own.
  std::set<std::string> ids;
  for (std::size_t at = page.find("data-from=\""); at != std::string::npos;
       at = page.find("data-from=\"", at + 1)) {
    const std::size_t begin = at + 11;
    ids.insert(page.substr(begin, page.find('"', begin) - begin));
  }
  EXPECT_EQ(ids.size(), 8u);
  for (const std::string& id : ids) EXPECT_EQ(count(page, "id=\"" + id + "\""), 1u) << id;
}

TEST(RunPage, WithoutPictures) {
  bench::Run run = made_up_run();
  run.complete = false;
  const std::string page = run_page(run);
  EXPECT_EQ(count(page, "<img"), 0u);
  EXPECT_NE(page.find("not all cells"), std::string::npos);
}

TEST(RunPage, AsksNothingOfTheNetwork) {
  const std::string page = run_page(made_up_run_with_pictures());
  EXPECT_EQ(count(page, "http://") + count(page, "https://") + count(page, "url(") + count(page, "@import"),
            0u);
  EXPECT_EQ(count(page, "src="), count(page, "src=\"data:"));
  EXPECT_EQ(count(page, "href="), count(page, "href=\"data:,\""));
}

}  // namespace
}  // namespace dermis::cli::bench
