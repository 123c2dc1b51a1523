// SPDX-License-Identifier: MIT
// `dermis bench`: what a tiny run prints and writes, what is refused, and what is said about two results.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Bench : public Program {
 protected:
  /// Two cells of a head of few triangles.
  Result tiny(const Arguments& arguments, const Surroundings& surroundings = {}) const {
    Arguments all{"bench", file("head.gltf", tiny_gltf())};
    for (const auto& [option, value] : {std::pair("--size", "48x30"),
                                        {"--map-size", "64"},
                                        {"--shadow-size", "64"},
                                        {"--heads", "1,3"},
                                        {"--distances", "5"},
                                        {"--rounds", "2"},
                                        {"--picture-samples", "1"}})
      if (std::find(arguments.begin(), arguments.end(), option) == arguments.end())
        all.insert(all.end(), {option, value});
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(all, surroundings);
  }
  json found(const Arguments& arguments = {}) const {
    Arguments all{"--json", "-"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Result result = tiny(all);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "") << "no progress where nobody watches";
    return json::parse(result.out, nullptr, false);
  }
};

TEST_F(Bench, AnswersOtherProgramsRelyOn) {
  const json j = found();
  for (const char* key : {"dermis", "commit", "device", "driver", "command", "scene", "timing"})
    EXPECT_TRUE(j.at(key).is_string() && j.at(key) != "") << key;
  EXPECT_NE(j.at("command").get<std::string>().find(" bench "), std::string::npos);
  EXPECT_EQ(j.at("settings").at("output").at("height"), 30);
  EXPECT_EQ(j.at("settings").at("quality").at("map_size"), 64);
  EXPECT_EQ(j.at("settings").at("scene").at("unit_scale"), 1);
  EXPECT_EQ(j.at("lights"), 2);
  EXPECT_EQ(j.at("gaussians"), 6);

  ASSERT_EQ(j.at("cells").size(), 2u);
  for (const json& cell : j.at("cells")) {
    EXPECT_EQ(cell.at("distance"), 5);
    for (const char* key : {"baseline_ms", "skip_ms", "cull_ms", "depth_ms", "clip_ms", "all_ms",
                            "all_margin_0_ms", "lambert_ms", "speedup", "psnr_db", "flip_mean"})
      EXPECT_TRUE(cell.at(key).is_number()) << key;
    EXPECT_NEAR(cell.at("speedup"), cell.at("baseline_ms").get<double>() / cell.at("all_ms").get<double>(),
                1e-9);
    EXPECT_GE(cell.at("psnr_db"), 20);
    EXPECT_GT(cell.at("compared_pixels"), 0);
    EXPECT_GT(cell.at("texels").at("baseline").at("irradiance"), 0);
    EXPECT_GE(cell.at("texels").at("baseline").at("irradiance"),
              cell.at("texels").at("all").at("irradiance"));
    EXPECT_EQ(cell.at("texels").at("baseline").at("used_size").size(), cell.at("heads"));

    const json& variants = cell.at("variants");
    for (const auto& [name, variant] : variants.items()) {
      SCOPED_TRACE(name);
      EXPECT_EQ(variant.at("rounds_ms").size(), 2u);
      EXPECT_GE(variant.at("ms").at("median"), variant.at("ms").at("min"));
      EXPECT_FALSE(variant.at("passes").empty());
    }

    EXPECT_EQ(variants.at("lambert").at("technique"), "lambert");
    EXPECT_EQ(variants.at("baseline").at("optimise"), json::array());
    EXPECT_EQ(variants.at("baseline").at("skip_unseen_heads"), false);
    EXPECT_EQ(variants.at("all").at("optimise"), json({"cull", "depth", "clip"}));
    EXPECT_EQ(variants.at("all").at("skip_unseen_heads"), true);
  }

  EXPECT_EQ(j.at("cells")[0].at("heads"), 1);
  EXPECT_EQ(j.at("cells")[0].at("paper_speedup"), 1.10);
  EXPECT_TRUE(j.at("cells")[1].at("paper_speedup").is_null()) << "the paper has no 3 heads";
}

// Counted, not timed: equal from run to run, whether frames wait in memory or are made anew for each turn.
TEST_F(Bench, CountsDoNotDependOnMemory) {
  const json held = found({"--heads", "2"}), anew = found({"--heads", "2", "--frames-memory", "0"});
  EXPECT_EQ(held.at("cells")[0].at("texels"), anew.at("cells")[0].at("texels"));
  EXPECT_EQ(held.at("cells")[0].at("psnr_db"), anew.at("cells")[0].at("psnr_db"));
  EXPECT_EQ(anew.at("cells")[0].at("variants").at("depth").at("rounds_ms").size(), 2u);
  EXPECT_EQ(held.at("cells")[0].at("variants").at("depth").at("passes").size(),
            anew.at("cells")[0].at("variants").at("depth").at("passes").size());
}

TEST_F(Bench, WithoutPictures) {
  const json cell = found({"--heads", "1", "--picture-samples", "0"}).at("cells")[0];
  EXPECT_TRUE(cell.at("psnr_db").is_null());
  EXPECT_TRUE(cell.at("flip_mean").is_null());
}

TEST_F(Bench, ListsAreSortedAndCellsAreAllTheirPairs) {
  const json j = found({"--heads", "2,1", "--distances", "20,5", "--rounds", "1", "--picture-samples", "0"});
  json places = json::array();
  for (const json& cell : j.at("cells")) places.push_back({cell.at("heads"), cell.at("distance")});
  EXPECT_EQ(places, json({{1, 5.0}, {1, 20.0}, {2, 5.0}, {2, 20.0}}));
}

TEST_F(Bench, ListsLeaveTheSceneAlone) {
  const Result result = run({"bench", "--heads", "1", (folder() / "a.gltf").string()});
  expect_refused(result, "a.gltf: no such file");
  expect_refused(run({"bench", "--distances", "5", (folder() / "a.gltf").string()}), "a.gltf: no such file");
}

TEST_F(Bench, LampsInPlaceOfTheRig) {
  const json j = found({"--heads", "1", "--rounds", "1", "--picture-samples", "0", "--light", "30,20"});
  EXPECT_EQ(j.at("lights"), 1);
  EXPECT_EQ(j.at("settings").at("lighting").at("placed_lights"),
            json({{{"azimuth_deg", 30.0}, {"elevation_deg", 20.0}, {"irradiance", 3.0}}}));
}

TEST_F(Bench, TechniquesAreNamedPerColumn) {
  const json cell =
      found({"--heads", "1", "--map-size", "512", "--rounds", "1", "--picture-samples", "0"}).at("cells")[0];
  EXPECT_EQ(cell.at("variants").at("compute").at("technique"), "texture-space");
  EXPECT_EQ(cell.at("variants").at("baseline").at("technique"), "published");
  EXPECT_EQ(cell.at("variants").at("lambert").at("technique"), "lambert");
}

TEST_F(Bench, TechniquesAsColumns) {
  const std::string page = (folder() / "grid.html").string();
  const json j = found({"--techniques", "texture-space,separable,lambert", "--html", page});
  ASSERT_EQ(j.at("cells").size(), 2u);
  for (const json& cell : j.at("cells")) {
    for (const char* key : {"texture-space_ms", "separable_ms", "lambert_ms"})
      EXPECT_GT(cell.at(key), 0) << key;
    EXPECT_FALSE(cell.contains("burley-disc_ms"));
    EXPECT_GT(cell.at("coverage"), 0);
    const json& separable = cell.at("variants").at("separable");
    EXPECT_EQ(separable.at("rounds_ms").size(), 2u);
    EXPECT_GT(separable.at("light_reads"), 0);
    EXPECT_GT(separable.at("per_view_ms"), 0);
    EXPECT_GT(cell.at("variants").at("texture-space").at("shared_by_views_ms"), 0);
  }
  EXPECT_FALSE(j.at("crossovers").empty());
  EXPECT_TRUE(read_text(page).starts_with("<!doctype html>"));

  // `--compare` reads it, too.
  const std::string own = (folder() / "grid.json").string();
  ASSERT_EQ(tiny({"--techniques", "separable", "--json", own}).status, 0);
  const Result compared = run({"bench", "--compare", own, own});
  EXPECT_EQ(compared.status, 0) << compared.err;

  const Result table = tiny({"--techniques", "all"});
  EXPECT_EQ(table.status, 0) << table.err;
  for (const char* part : {"burley-disc", "lambert", "against"})
    EXPECT_NE(table.out.find(part), std::string::npos) << part;
  expect_refused(
      tiny({"--techniques", "oil"}),
      "texture-space, lambert, screen-gaussians, separable, burley-disc, pre-integrated, published");
}

TEST_F(Bench, ATableForPeopleAndAPage) {
  const fs::path page = folder() / "page.html", numbers = folder() / "numbers.json";
  const Result result = tiny({"--html", page.string(), "--json", numbers.string()});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* part : {"heads distance |", "speed-up", "paper", "(1.10)", "lambert", "48x30 pixels"})
    EXPECT_NE(result.out.find(part), std::string::npos) << part;
  EXPECT_EQ(json::parse(read_text(numbers)).at("cells").size(), 2u);
  const std::string html = read_text(page);
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_TRUE(html.ends_with("</html>\n"));
  for (const char* outside : {"http://", "https://", "url(", "@import"})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  EXPECT_EQ(html.find("> other</span>"), std::string::npos) << "a pass that no group of the bars knows";
  EXPECT_NE(html.find("id=\"map-visibility\""), std::string::npos);
}

TEST_F(Bench, RefusesBeforeItMeasures) {
  const auto refuse = [&](const Arguments& arguments, const std::string& says) {
    SCOPED_TRACE(arguments.front() + " " + arguments.back());
    expect_refused(tiny(arguments), says);
  };

  refuse({"--heads", "1,2,1"}, "--heads names 1 twice");
  refuse({"--heads", "0"}, "(--heads) must be 1 to 1024, got 0");
  refuse({"--heads", ""}, "(--heads) must be 1 to 1024, got 0");
  refuse({"--heads", "1,2000"}, "(--heads) must be 1 to 1024, got 2000");
  refuse({"--distances", "5,-1"}, "(--distances) must be");
  refuse({"--distances", "5,nan"}, "--distance");
  refuse({"--rounds", "0"}, "--rounds must be 1 to 100000, got 0");
  refuse({"--picture-samples", "17"}, "--picture-samples must be 0 to 16");
  refuse({"--size", "8000x10", "--picture-samples", "4"}, "--picture-samples 4 of 8000x10 pixels");
  refuse({"--frames-memory", "-1"}, "--frames-memory must be 0");
  refuse({"--set", "quality.mask=paper"}, "alpha, depth");
  refuse({"--map-size", "8"}, "(--map-size) must be 32");
  refuse({"--html", "-"}, "--html: needs a file");
  refuse({"--html", (folder() / "none" / "page.html").string()}, "does not exist");
  refuse({"--json", (folder() / "same").string(), "--html", (folder() / "." / "same").string()},
         "--json needs its own");
  refuse({"--fail-if-slower"}, "--fail-if-slower: is for --compare");
  expect_refused(run({"bench", (folder() / "none.glb").string()}), "none.glb");

  expect_not_understood(tiny({"--heads", "many"}), "--heads");
  expect_not_understood(tiny({"--heads", "1.5"}), "--heads");
  expect_not_understood(tiny({"--distances", "near"}), "--distances");
  expect_not_understood(tiny({"--optimise", "all"}), "--optimise");
  expect_not_understood(tiny({"--technique", "lambert"}), "--technique");
}

TEST_F(Bench, StoppedInItsFirstCellItWritesNothing) {
  const fs::path numbers = folder() / "numbers.json";
  const Result result = tiny({"--rounds", "100000", "--json", numbers.string()}, {.interrupt_after_s = 3});
  expect_refused(result, "stopped before the first cell was measured: nothing to write");
  EXPECT_FALSE(fs::exists(numbers));
}

TEST_F(Bench, StoppedLaterItWritesWhatIsComplete) {
  const fs::path numbers = folder() / "numbers.json", page = folder() / "page.html";
  std::string distances = "3";
  for (int i = 4; i < 300; ++i) distances += "," + std::to_string(i);
  const Result result =
      tiny({"--distances", distances, "--rounds", "1", "--json", numbers.string(), "--html", page.string()},
           {.interrupt_after_text = "maps of all\n"});  // ends the head of the table: a cell is there
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("dermis: stopped after "), std::string::npos) << result.err;
  const json j = json::parse(read_text(numbers));
  EXPECT_EQ(j.at("complete"), false);
  EXPECT_GE(j.at("cells").size(), 1u);
  EXPECT_LT(j.at("cells").size(), 2 * 297u);
  EXPECT_TRUE(read_text(page).ends_with("</html>\n"));
  EXPECT_NE(read_text(page).find("not all cells were measured"), std::string::npos);
}

class CompareResults : public Program {
 protected:
  /// One cell whose baseline took these times.
  std::string result(const std::string& name, const std::vector<double>& rounds_ms,
                     const std::string& scene = "head.glb") const {
    const json times{{"rounds_ms", rounds_ms},
                     {"passes", json::array({{{"name", "blur 0 u"}, {"ms", rounds_ms.front()}}})}};
    const json cell{{"heads", 4}, {"distance", 2.5}, {"variants", {{"baseline", times}}}};
    return file(name, json{{"commit", name},
                           {"device", "d"},
                           {"scene", scene},
                           {"settings", {{"map_size", 64}}},
                           {"cells", {cell}}}
                          .dump());
  }
};

TEST_F(CompareResults, ASlowdownBeyondTheSpread) {
  const std::string before = result("old.json", {100, 104, 102}), after = result("new.json", {120, 126, 122});
  const Result text = run({"bench", "--compare", before, after});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("1 of 1 times are slower"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("baseline"), std::string::npos);
  EXPECT_NE(text.out.find("+19.6%"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("blur 0 u +20 ms"), std::string::npos) << text.out;
  const json j = json::parse(run({"bench", "--compare", before, after, "--json", "-"}).out);
  ASSERT_EQ(j.at("slower").size(), 1u);
  EXPECT_EQ(j.at("slower")[0].at("heads"), 4);
  EXPECT_NEAR(j.at("slower")[0].at("beyond"), 16.0 / 102, 1e-9);
  const Result failed = run({"bench", "--compare", before, after, "--fail-if-slower"});
  EXPECT_EQ(failed.status, 1);
  EXPECT_EQ(failed.err, "dermis: 1 of 1 times are slower beyond the spread\n");
  EXPECT_EQ(run({"bench", "--compare", after, before, "--fail-if-slower"}).status, 0)
      << "faster is not slower";
}

TEST_F(CompareResults, OneWithinItIsIgnored) {
  const Result text = run({"bench", "--compare", result("old.json", {100, 104, 102}),
                           result("new.json", {103, 110, 106}), "--fail-if-slower"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("0 of 1 times are slower, 0 are faster"), std::string::npos) << text.out;
  EXPECT_EQ(text.out.find("baseline"), std::string::npos) << "nothing to list";
}

TEST_F(CompareResults, WhatCannotBeCompared) {
  const std::string a = result("a.json", {1, 2, 3}), before = read_text(a);
  expect_refused(run({"bench", "--compare", a, result("other.json", {1}, "other.glb")}),
                 "other.json: the scene is other.glb");
  expect_refused(run({"bench", "--compare", a, (folder() / "none.json").string()}),
                 "none.json: no such file");
  expect_refused(run({"bench", "--compare", a, file("text.json", "no")}), "text.json: is not valid JSON");
  expect_refused(run({"bench", "--compare", a, file("empty.json", "{}")}), "empty.json: has no 'commit'");
  expect_refused(run({"bench", "--compare", a, a, "--json", a}), "needs a name of its own");
  expect_refused(run({"bench", "--compare", a, a, "--html", (folder() / "x.html").string()}),
                 "--html: is for runs");
  expect_refused(run({"bench", "head.glb", "--compare", a, a}), "it needs no scene");
  EXPECT_EQ(read_text(a), before);
  expect_not_understood(run({"bench", "--compare", a}), "--compare");
}

}  // namespace
}  // namespace dermis::tests
