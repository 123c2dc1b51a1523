// SPDX-License-Identifier: MIT
// Recipes: what they say, what is refused, and that a sample depends on recipe and number alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "dermis/dataset.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::dataset {
namespace {

using Json = nlohmann::json;

Json plain() {
  return Json::parse(R"({
    "schema": 1, "name": "test", "seed": 5, "samples": 40, "samples_per_shard": 8, "views_per_identity": 2,
    "size": [96, 96], "labels": ["depth", "region"],
    "identities": [
      {"asset": "built-in:light"},
      {"asset": "a.glb", "count": 9, "morphs": {"id_a": {"normal": [0, 1], "within": [-2, 2]}},
       "licence": {"spdx": "CC-BY-4.0", "author": "A", "source": "https://example.org"}}],
    "settings": {
      "camera": {"fov_deg": {"uniform": [15, 35]},
                 "orbit_deg": [{"normal": [0, 20], "within": [-60, 60]}, 5]},
      "lighting": {"environment": {"choice": ["studio", ""], "weights": [3, 1]},
                   "environment_intensity": {"log_uniform": [0.1, 10]},
                   "rig_lights": {"whole": [0, 3]},
                   "ambient": {"table": {"edges": [0, 0.1, 1], "weights": [3, 1]}}},
      "output": {"exposure_ev": 0}},
    "pose": {"weights": {"jawOpen": {"uniform": [0, 1]}}},
    "head": {"turn_deg": [{"uniform": [-5, 5]}, 0, 0]}})");
}

Recipe recipe(const Json& json) { return Recipe::parse(json.dump(), "."); }
Json sample(const Recipe& r, std::uint64_t i) { return Json::parse(r.parameters(i)); }

std::string refused(const std::string& pointer, const Json& value) {
  Json json = plain();
  json[Json::json_pointer(pointer)] = value;
  return tests::thrown<InputError>([&] { recipe(json); });
}
void expect_refused(const std::string& pointer, const Json& value, const std::string& says) {
  const std::string found = refused(pointer, value);
  EXPECT_NE(found.find(says), std::string::npos) << pointer << ": " << found;
  EXPECT_EQ(found.find('\n'), std::string::npos) << found;
}

TEST(Recipe, ASampleDependsOnRecipeAndNumberAlone) {
  const Recipe a = recipe(plain()), b = recipe(plain());
  std::set<std::string> all;
  for (std::uint64_t i = 40; i-- > 0;) all.insert(a.parameters(i));
  EXPECT_EQ(all.size(), 40u);
  for (std::uint64_t i = 0; i < 40; ++i) EXPECT_TRUE(all.contains(b.parameters(i))) << i;

  Json other = plain();
  other["seed"] = 6;
  EXPECT_NE(recipe(other).parameters(3), a.parameters(3));
}

// To the last digit: these stand in data sets that people have.
TEST(Recipe, ValuesAreTheseForGood) {
  const Json s = sample(recipe(plain()), 17);
  EXPECT_EQ(s["settings"].dump(),
            R"({"camera":{"fov_deg":18.93176108318936,"orbit_deg":[-21.021096902743757,5]},)"
            R"("lighting":{"ambient":0.009939412728045383,"environment":"",)"
            R"("environment_intensity":1.1196440135350274,"rig_lights":2},"output":{"exposure_ev":0}})");
}

TEST(Recipe, AParameterDoesNotMoveWhenAnotherIsAdded) {
  Json more = plain();
  more["settings"]["lighting"]["environment_rotation_deg"] = {{"uniform", {0, 360}}};
  const Json before = sample(recipe(plain()), 11), after = sample(recipe(more), 11);
  EXPECT_EQ(before["settings"]["camera"], after["settings"]["camera"]);
  EXPECT_EQ(before["pose"], after["pose"]);
}

TEST(Recipe, DistributionsAreWhatTheySay) {
  Json json = plain();
  json["samples"] = 6'000;
  const Recipe r = recipe(json);
  double fov = 0, orbit = 0, squares = 0, dim = 0;
  std::map<std::string, double> places;
  std::map<int, double> lights;
  for (std::uint64_t i = 0; i < 6'000; ++i) {
    const Json s = sample(r, i)["settings"];
    fov += s["camera"]["fov_deg"].get<double>() / 6'000;
    const double turn = s["camera"]["orbit_deg"][0];
    ASSERT_LE(std::abs(turn), 60);
    orbit += turn / 6'000, squares += turn * turn / 6'000;
    places[s["lighting"]["environment"].get<std::string>()] += 1.0 / 6'000;
    lights[s["lighting"]["rig_lights"].get<int>()] += 1.0 / 6'000;
    dim += s["lighting"]["ambient"].get<double>() < 0.1 ? 1.0 / 6'000 : 0;
    const double bright = s["lighting"]["environment_intensity"];
    ASSERT_TRUE(bright >= 0.1 && bright <= 10) << bright;
  }
  EXPECT_NEAR(fov, 25, 0.3);
  EXPECT_NEAR(orbit, 0, 1);
  EXPECT_NEAR(std::sqrt(squares), 19.73, 0.7) << "of a normal of 20 cut at three deviations";
  EXPECT_NEAR(places["studio"], 0.75, 0.025);
  EXPECT_NEAR(dim, 0.75, 0.025);
  EXPECT_EQ(lights.size(), 4u);
  for (const auto& [count, share] : lights) EXPECT_NEAR(share, 0.25, 0.025) << count;
}

TEST(Recipe, ViewsOfASittingShareThePerson) {
  const Recipe r = recipe(plain());
  for (std::uint64_t i = 0; i < 40; i += 2) {
    const Json a = sample(r, i), b = sample(r, i + 1);
    EXPECT_EQ(a["identity"], b["identity"]);
    EXPECT_NE(a["settings"]["camera"], b["settings"]["camera"]);
    EXPECT_NE(a["pose"], b["pose"]);
  }
  Json json = plain();
  json["shared_by_views"] = {"pose", "settings.lighting"};
  const Recipe shared = recipe(json);
  EXPECT_EQ(sample(shared, 6)["pose"], sample(shared, 7)["pose"]);
  EXPECT_EQ(sample(shared, 6)["settings"]["lighting"], sample(shared, 7)["settings"]["lighting"]);
  EXPECT_NE(sample(shared, 6)["settings"]["camera"], sample(shared, 7)["settings"]["camera"]);
  EXPECT_NE(sample(shared, 6)["pose"], sample(shared, 8)["pose"]);
}

TEST(Recipe, NobodyIsInBothSplits) {
  Json json = plain();
  json["test_share"] = 0.3;
  const Recipe r = recipe(json);
  EXPECT_EQ(r.identities(), 10u);
  std::map<std::string, std::set<int>> people;
  std::map<std::string, std::uint64_t> counts;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Json s = sample(r, i);
    people[s["split"]].insert(s["identity"]["number"].get<int>());
    ++counts[s["split"]];
  }
  EXPECT_EQ(people["test"].size(), 3u);
  EXPECT_EQ(people["train"].size(), 7u);
  for (const int k : people["test"]) EXPECT_FALSE(people["train"].contains(k)) << k;
  EXPECT_EQ(counts["test"], 12u);

  // No shard holds both.
  EXPECT_EQ(r.shards(), 4u + 2u);
  std::uint64_t next = 0;
  for (std::uint64_t shard = 0; shard < r.shards(); ++shard) {
    const auto [first, count] = r.samples_of(shard);
    EXPECT_EQ(first, next);
    next += count;
    for (std::uint64_t i = first; i < next; ++i)
      EXPECT_EQ(sample(r, i)["split"], r.file_of(shard).substr(0, r.file_of(shard).find('-')));
  }
  EXPECT_EQ(next, 40u);
  EXPECT_EQ(r.file_of(3), "train-000003.tar");
  EXPECT_EQ(r.file_of(4), "test-000004.tar");
}

TEST(Recipe, PeopleOfOneAssetDiffer) {
  const Recipe r = recipe(plain());
  std::map<int, std::string> morphs;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Json identity = sample(r, i)["identity"];
    const auto [at, added] = morphs.emplace(identity["number"].get<int>(), identity["morphs"].dump());
    EXPECT_EQ(at->second, identity["morphs"].dump());
  }
  std::set<std::string> distinct;
  for (const auto& [number, text] : morphs) distinct.insert(text);
  EXPECT_EQ(morphs.size(), 10u);
  EXPECT_EQ(distinct.size(), 10u);
}

TEST(Recipe, ThatOfTheDocumentIsOne) {
  const std::string document = tests::read_text(DERMIS_SOURCE_DIR "/python/datasets.md");
  const std::size_t begin = document.find("```json\n") + 8, end = document.find("```", begin);
  const Recipe r = Recipe::parse(document.substr(begin, end - begin), ".");
  EXPECT_EQ(r.samples(), 4000u);
  EXPECT_EQ(r.identities(), 6u);
}

TEST(Recipe, ItsHashIsThatOfItsValues) {
  Json other = plain();
  EXPECT_EQ(Recipe::parse(plain().dump(4), ".").sha256(), recipe(other).sha256());
  other["seed"] = 6;
  EXPECT_NE(recipe(other).sha256(), recipe(plain()).sha256());
}

TEST(Recipe, MistakesAreNamed) {
  expect_refused("/sampels", 1, "sampels");
  expect_refused("/schema", 2, "schema");
  expect_refused("/samples", 41, "multiple of views_per_identity (2)");
  expect_refused("/samples", 0, "samples");
  expect_refused("/size", {96}, "size");
  expect_refused("/size/0", 96.5, "size");
  expect_refused("/seed", -1, "seed");
  expect_refused("/labels/0", "dept", "did you mean 'depth'?");
  expect_refused("/labels/0", "motion", "between frames");
  expect_refused("/test_share", 1, "leaves nobody to train on");
  expect_refused("/identities", Json::array(), "identities");
  expect_refused("/identities/0/count", 2, "nothing tells these identities apart");
  expect_refused("/identities/1/licence/author", "", "author");
  expect_refused("/identities/1/licence/spdx", "CC BY / 4.0", "no SPDX identifier");
  expect_refused("/identities/1/options", {{"melanin", 2}}, "melanin_factor");
  expect_refused("/identities/1/morphs/id_b", "big", "id_b");
  expect_refused("/settings/camera/fov", 20, "fov_deg");
  expect_refused("/settings/output/width", 20, "size");
  expect_refused("/settings/output/exposure_ev", nullptr, "exposure_ev must be a number");
  expect_refused("/settings/camera/heads", {{"whole", {1, 2}}}, "heads must be 1");
  expect_refused("/pose/weights/jawOpen", 101, "jawOpen");
  expect_refused("/head/turn", {0, 0, 0}, "turn_deg");
  expect_refused("/shared_by_views", {"light"}, "begins with none of");
}

TEST(Recipe, DistributionsAreHeldAgainstTheRowsOfTheSettings) {
  const std::string fov = "/settings/camera/fov_deg";
  expect_refused(fov, {{"uniform", {15, 171}}}, "0.1 to 170");
  expect_refused(fov, {{"choice", {20, {{"uniform", {30, 500}}}}}}, "0.1 to 170");
  expect_refused(fov,
                 {{
                      "normal",
                      {20, 5},
                  },
                  {"within", {-1, 40}}},
                 "0.1 to 170");
  expect_refused(fov, {{"uniform", {35, 15}}}, "least below most");
  expect_refused(fov, {{"uniform", {35}}}, "uniform");
  expect_refused(fov, {{"uniform", 35}}, "uniform");
  expect_refused(fov, {{"normal", {20, 5}}}, "needs \"within\"");
  expect_refused(fov, {{"normal", {20, 0}}, {"within", {10, 30}}}, "above 0");
  expect_refused(fov, {{"normal", {20, 1}}, {"within", {40, 50}}}, "too little of the distribution");
  expect_refused(fov, {{"log_uniform", {0, 5}}}, "above 0");
  expect_refused(fov, {{"choice", Json::array()}}, "choice");
  expect_refused(fov, {{"choice", {20, 30}}, {"weights", {1}}}, "weights");
  expect_refused(fov, {{"choice", {20, 30}}, {"weights", {0, 0}}}, "all 0");
  expect_refused(fov, {{"table", {{"edges", {1, 1}}, {"weights", {1}}}}}, "rise");
  expect_refused(fov, {{"uniform", {15, 20}}, {"weight", 1}}, "weight");
  expect_refused("/settings/lighting/rig_lights", {{"uniform", {0, 3}}}, "rig_lights");
  expect_refused("/settings/lighting/rig_lights", {{"whole", {0.5, 3}}}, "whole number");
}

TEST(Recipe, NumbersOutsideAreRefused) {
  const Recipe r = recipe(plain());
  EXPECT_NE(tests::thrown<InputError>([&] { r.parameters(40); }).find("no sample 40"), std::string::npos);
  EXPECT_NE(tests::thrown<InputError>([&] { r.samples_of(5); }).find("no shard 5"), std::string::npos);
}

TEST(Recipe, HostileTextsEndInOneLine) {
  const std::string text = plain().dump();
  for (std::size_t cut = 0; cut < text.size(); cut += 13) {
    const std::string found =
        tests::thrown<InputError>([&] { Recipe::parse(std::string_view(text).substr(0, cut), "."); });
    EXPECT_NE(found, "nothing was thrown") << cut;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
  std::string deep;
  for (int i = 0; i < 10'000; ++i) deep += "{\"choice\":[";
  EXPECT_NE(tests::thrown<InputError>([&] { Recipe::parse(deep, "."); }), "nothing was thrown");
}

}  // namespace
}  // namespace dermis::dataset
