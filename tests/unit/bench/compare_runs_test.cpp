// SPDX-License-Identifier: MIT
// Two recorded runs: what changed is found, what did not is not, what is no result is refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/core/file.h"
#include "cli/bench/recorded.h"
#include "dermis/error.h"
#include "unit/bench/made_up.h"

namespace dermis::cli::bench {
namespace {

using nlohmann::json;
using tests::made_up_run;

class CompareRuns : public testing::Test {
 protected:
  ~CompareRuns() override {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Recorded recorded(const json& j) { return recorded(j.dump()); }
  Recorded recorded(const std::string& text) {
    write_file(path_, text);
    return read_recorded(path_.string());
  }
  static json made_up() { return json::parse(run_json(made_up_run())); }
  // All rounds of one variant of the second cell, times a factor.
  static json changed(const std::string& variant, double factor) {
    json j = made_up();
    json& times = j["cells"][1]["variants"][variant];
    for (json& ms : times["rounds_ms"]) ms = factor * ms.get<double>();
    times["passes"][1]["ms"] = factor * times["passes"][1]["ms"].get<double>();
    return j;
  }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("dermis-compare-runs-" + std::to_string(::getpid()) + ".json");
};

constexpr unsigned variant_count = 10;

TEST_F(CompareRuns, EqualRunsAreEqual) {
  const RunComparison found = compare_runs(recorded(made_up()), recorded(made_up()));
  EXPECT_EQ(found.compared, 4u * variant_count);
  EXPECT_EQ(found.slower + found.faster + found.changes.size(), 0u);
  EXPECT_NEAR(found.by_chance, 4 * variant_count / 20.0, 1e-9);
  EXPECT_NE(comparison_text(found).find("0 of 40 times are slower, 0 are faster"), std::string::npos)
      << comparison_text(found);
}

// Settings once had no sections, and the pass of the tone map was called "view".
TEST_F(CompareRuns, AnOlderRecordIsUnderstood) {
  json old = made_up();
  old["settings"] = {{"size", {1280, 720}},
                     {"map_size", 2048},
                     {"samples", 4},
                     {"lights", 2},
                     {"gaussians", 6},
                     {"mask", nullptr},
                     {"maps", "full"},
                     {"environment", ""},
                     {"fov_deg", nullptr},
                     {"profile", ""},
                     {"placed_lights", json::array()},
                     {"bloom", 0.05},
                     {"light_radius", nullptr}};
  old.erase("lights");
  old.erase("gaussians");
  for (json& cell : old["cells"])
    for (json& variant : cell["variants"])
      for (json& pass : variant["passes"])
        if (pass["name"] == "tone map") pass["name"] = "view";

  const Recorded read = recorded(old);
  EXPECT_EQ(read.cells[0].times[0].passes.back().name, "tone map");
  EXPECT_EQ(compare_runs(read, recorded(made_up())).compared, 4u * variant_count);

  // What it says of its settings is still held against those of a newer one.
  const auto refused = [&](const std::string& name, const json& value, const std::string& says) {
    json other = old;
    other["settings"][name] = value;
    try {
      compare_runs(recorded(other), recorded(made_up()));
      ADD_FAILURE() << name << " is compared";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("setting '" + says + "' is "), std::string::npos)
          << error.what();
    }
  };
  refused("size", {1280, 721}, "output.height");
  refused("map_size", 64, "quality.map_size");
  refused("profile", "skin", "skin.profile");
  refused("gaussians", 4, "gaussians");
  refused("placed_lights", {{30, 20, 3}}, "lighting.placed_lights");
}

TEST_F(CompareRuns, LampsOfAnOlderRecordAreThoseOfANewerOne) {
  json old = made_up(), now = made_up();
  old["settings"] = {{"placed_lights", {{30.0, 20.0, 3.0}}}};
  now["settings"]["lighting"]["placed_lights"] = {
      {{"azimuth_deg", 30.0}, {"elevation_deg", 20.0}, {"irradiance", 3.0}}};
  EXPECT_EQ(compare_runs(recorded(old), recorded(now)).compared, 4u * variant_count);
}

TEST_F(CompareRuns, ASlowdownIsFoundAndExplained) {
  const RunComparison found = compare_runs(recorded(made_up()), recorded(changed("cull", 1.5)));
  ASSERT_EQ(found.changes.size(), 1u);
  EXPECT_EQ(found.slower, 1u);
  const TimeChange& c = found.changes.front();
  EXPECT_EQ(c.heads, 1);
  EXPECT_EQ(c.distance, 7);
  EXPECT_EQ(c.variant, "cull");
  EXPECT_NEAR(c.found.ratio, 1.5, 1e-9);
  EXPECT_EQ(c.pass, "blur 0 u");
  EXPECT_NEAR(c.pass_ms, c.before_ms / 4, 1e-9);
  // 36 ms in rounds of 35, 36, 37: 52.5 to 55.5.
  EXPECT_NEAR(c.found.beyond, (52.5 - 37) / 36, 1e-9);
  EXPECT_NE(comparison_text(found).find("+50.0%"), std::string::npos) << comparison_text(found);
  EXPECT_EQ(json::parse(comparison_json(found)).at("slower").at(0).at("what"), "cull");
}

TEST_F(CompareRuns, OneWithinTheSpreadIsNot) {
  EXPECT_EQ(compare_runs(recorded(made_up()), recorded(changed("cull", 1.03))).changes.size(), 0u);
  EXPECT_EQ(compare_runs(recorded(made_up()), recorded(changed("cull", 0.97))).changes.size(), 0u);
}

TEST_F(CompareRuns, FasterComesAfterSlower) {
  json j = changed("cull", 0.5);
  for (json& ms : j["cells"][3]["variants"]["depth"]["rounds_ms"]) ms = 1.1 * ms.get<double>();
  const RunComparison found = compare_runs(recorded(made_up()), recorded(j));
  ASSERT_EQ(found.changes.size(), 2u);
  EXPECT_EQ(found.changes[0].found.change, Change::slower);
  EXPECT_EQ(found.changes[1].found.change, Change::faster);
  EXPECT_LT(found.changes[1].pass_ms, 0);
}

TEST_F(CompareRuns, OnlyWhatBothHaveIsCompared) {
  json j = made_up();
  j["cells"].erase(0);
  j["cells"][0]["variants"].erase("lambert");
  const RunComparison found = compare_runs(recorded(made_up()), recorded(j));
  EXPECT_EQ(found.compared, 3u * variant_count - 1);
  EXPECT_EQ(found.only_before, variant_count + 1);
  EXPECT_EQ(found.only_after, 0u);
  j["cells"] = json::array();
  EXPECT_THROW(compare_runs(recorded(made_up()), recorded(j)), InputError);
}

TEST_F(CompareRuns, AnotherTestIsNotComparable) {
  json j = made_up();
  j["settings"]["quality"]["map_size"] = 64;
  try {
    compare_runs(recorded(made_up()), recorded(j));
    FAIL() << "compared";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("setting 'quality.map_size' is 64, in "), std::string::npos)
        << error.what();
  }
  json scene = made_up();
  scene["scene"] = "another.glb";
  EXPECT_THROW(compare_runs(recorded(made_up()), recorded(scene)), InputError);
  json device = made_up();
  device["device"] = "another";
  EXPECT_NE(comparison_text(compare_runs(recorded(made_up()), recorded(device))).find("devices differ"),
            std::string::npos);
}

TEST_F(CompareRuns, WhatIsNoResultIsRefusedWithItsPlace) {
  const auto refuse = [&](const std::string& text, const std::string& says) {
    try {
      recorded(text);
      FAIL() << "read: " << text.substr(0, 60);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };

  refuse("{", "is not valid JSON");
  refuse("[]", "has no 'commit'");
  refuse("{}", "has no 'commit'");
  refuse(std::string(100000, '['), "nested deeper");

  const auto broken = [&](const std::string& pointer, const json& value, const std::string& says) {
    json j = made_up();
    j[json::json_pointer(pointer)] = value;
    refuse(j.dump(), says);
  };
  broken("/cells", 5, "cells: must be an array");
  broken("/cells/1/heads", "two", "cells[1].heads: must be an integer");
  broken("/cells/1/heads", 1e300, "cells[1].heads: must be 1 to 1000000");
  broken("/cells/0/variants", json::array(), "cells[0].variants: must be an object");
  broken("/cells/0/variants/cull/rounds_ms", json::array(),
         "cells[0].variants.cull.rounds_ms: must have 1 to");
  broken("/cells/0/variants/cull/rounds_ms/2", -1, "rounds_ms[2]: must be 0 to");
  broken("/cells/0/variants/cull/rounds_ms/2", nullptr, "rounds_ms[2]: must be a number");
  broken("/cells/0/variants/cull/passes/0/name", 1, "passes[0].name: must be a string");

  json twice = made_up();
  twice["cells"][1] = twice["cells"][0];
  refuse(twice.dump(), "cells[1]: is there twice");
  json settings = made_up();
  settings.erase("settings");
  refuse(settings.dump(), "has no 'settings'");

  // The way to a value goes through the names of the file, which may hold anything; the message is one line.
  json odd = made_up();
  odd["cells"][0]["variants"]["a\nb"] = 1;
  refuse(odd.dump(), "cells[0].variants.a?b");
}

}  // namespace
}  // namespace dermis::cli::bench
