// SPDX-License-Identifier: MIT
// `dermis reference`: what it refuses, what a stopped run leaves, and that the way there makes no difference
// to the picture.
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

const Surroundings no_driver{.variables = {"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"}};

class Reference : public Program {
 protected:
  std::string head() const { return file("head.gltf", tiny_gltf()); }
  std::string in_folder(const std::string& name) const { return (folder() / name).string(); }
  /// Small, to `output`. Without a Vulkan driver: none is needed.
  Result reference(const std::string& output, const Arguments& arguments,
                   Surroundings surroundings = no_driver) const {
    Arguments all{"reference", head(), "-o", in_folder(output)};
    if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
      all.insert(all.end(), {"--size", "24x24"});
    all.insert(all.end(), arguments.begin(), arguments.end());
    surroundings.variables = no_driver.variables;
    return run(all, surroundings);
  }
};

TEST_F(Reference, IsTheSameOnAnyNumberOfThreadsAndNeedsNoDevice) {
  for (const std::string model : {"bssrdf", "volume", "gaussians"}) {
    const Arguments options{"--model", model, "--samples", "3", "--medium", "skin1"};
    const auto with = [&](std::initializer_list<std::string> more) {
      Arguments all = options;
      all.insert(all.end(), more);
      return all;
    };

    const Result one = reference("a.exr", with({"--threads", "1", "--variance", in_folder("va.exr")}));
    EXPECT_EQ(one.status, 0) << one.err;
    const Result many = reference("b.exr", with({"--threads", "3", "--variance", in_folder("vb.exr")}));
    EXPECT_EQ(many.status, 0) << many.err;

    EXPECT_TRUE(read_text(folder() / "a.exr").starts_with("\x76\x2f\x31\x01"));
    EXPECT_EQ(read_text(folder() / "a.exr"), read_text(folder() / "b.exr"));
    EXPECT_EQ(read_text(folder() / "va.exr"), read_text(folder() / "vb.exr"));

    EXPECT_EQ(reference("c.exr", with({"--seed", "2"})).status, 0);
    EXPECT_NE(read_text(folder() / "a.exr"), read_text(folder() / "c.exr"));
  }

  EXPECT_FALSE(fs::exists(folder() / "a.exr.resume"));
  EXPECT_EQ(reference("a.png", {"--samples", "1"}).status, 0);
  EXPECT_TRUE(read_text(folder() / "a.png").starts_with("\x89PNG"));
}

// Light without width leaves where it entered: the model of what techniques blur takes it, the others do not.
TEST_F(Reference, OnlyGaussiansTakeATermWithoutWidth) {
  const std::string profile = file("zero.json", R"({"name": "zero", "variances_mm2": [0, 2],
    "weights": [[0.5, 0.5, 0.5], [0.5, 0.5, 0.5]]})");
  const Result made =
      reference("a.exr", {"--samples", "2", "--profile", profile, "--model", "gaussians", "--stats", "-"});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_NE(made.out.find("gaussians"), std::string::npos) << made.out;
  expect_refused(reference("b.exr", {"--samples", "2", "--profile", profile}), "must be > 0 mm^2");

  // Of other profiles it is the same integral, to the bit.
  EXPECT_EQ(reference("c.exr", {"--samples", "2", "--model", "gaussians"}).status, 0);
  EXPECT_EQ(reference("d.exr", {"--samples", "2"}).status, 0);
  EXPECT_EQ(read_text(folder() / "c.exr"), read_text(folder() / "d.exr"));
}

TEST_F(Reference, CtrlCWritesWhatThereIsAndResumeGoesOn) {
  Surroundings interrupted;
  interrupted.interrupt_after_s = 1.5;
  const Result stopped = reference("a.exr", {"--samples", "100000000"}, interrupted);
  EXPECT_EQ(stopped.status, 1);
  ASSERT_TRUE(fs::exists(folder() / "a.exr")) << stopped.err;
  ASSERT_TRUE(fs::exists(folder() / "a.exr.resume"));
  const std::string says = "stopped after ";
  ASSERT_NE(stopped.err.find(says), std::string::npos) << stopped.err;
  const int samples = std::atoi(stopped.err.c_str() + stopped.err.find(says) + says.size());
  ASSERT_GT(samples, 0);
  EXPECT_EQ(std::count(stopped.err.begin(), stopped.err.end(), '\n'), 1) << stopped.err;

  // Another picture's checkpoint is refused, and stays.
  expect_refused(reference("a.exr", {"--resume", "--ambient", "0.5"}), "belongs to another picture");
  const std::string wanted = std::to_string(samples + 5);
  const Result resumed = reference("a.exr", {"--samples", wanted, "--resume"});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_FALSE(fs::exists(folder() / "a.exr.resume"));
  EXPECT_EQ(reference("whole.exr", {"--samples", wanted}).status, 0);
  EXPECT_EQ(read_text(folder() / "a.exr"), read_text(folder() / "whole.exr"));
  // With nothing to go on from, it begins.
  EXPECT_EQ(reference("whole.exr", {"--samples", "2", "--resume"}).status, 0);
}

TEST_F(Reference, AFullDiskIsAnErrorThatLeavesNothing) {
  const Result result = reference("a.exr", {"--samples", "2"}, {.file_bytes = 600});
  expect_refused(result, "a.exr: cannot be written");
  EXPECT_FALSE(fs::exists(folder() / "a.exr"));
}

TEST_F(Reference, StatisticsHoldTheSettingsOfTheRun) {
  const std::string stats = in_folder("stats.json"), saved = in_folder("saved.json");
  const Result first = reference("a.exr", {"--samples", "2", "--seed", "18446744073709551615", "--orbit",
                                           "20,0", "--stats", stats, "--save-settings", saved});
  ASSERT_EQ(first.status, 0) << first.err;
  const auto written = nlohmann::json::parse(read_text(stats));
  EXPECT_EQ(written.at("samples"), 2);
  EXPECT_EQ(written.at("complete"), true);
  EXPECT_EQ(written.at("settings"), nlohmann::json::parse(read_text(saved)));
  EXPECT_EQ(written.at("settings").at("reference").at("seed"), 18446744073709551615u);
  EXPECT_EQ(written.at("settings").at("camera").at("orbit_deg").at(0), 20);

  // They are what --settings reads: the same picture again, and what is given by itself wins.
  const std::string settings = file("settings.json", written.at("settings").dump());
  ASSERT_EQ(reference("b.exr", {"--settings", settings}).status, 0);
  EXPECT_EQ(read_text(folder() / "a.exr"), read_text(folder() / "b.exr"));
  ASSERT_EQ(reference("b.exr", {"--settings", settings, "--seed", "2"}).status, 0);
  EXPECT_NE(read_text(folder() / "a.exr"), read_text(folder() / "b.exr"));
  // Another command leaves alone what only this one has.
  EXPECT_EQ(run({"plan", head(), "--settings", settings}, no_driver).status, 0);
}

TEST_F(Reference, RefusesWhatMakesNoSense) {
  const auto refuse = [&](const Arguments& arguments, const std::string& says) {
    SCOPED_TRACE(arguments[0] + " " + arguments[1]);
    expect_refused(reference("r.exr", arguments), says);
    EXPECT_FALSE(fs::exists(folder() / "r.exr"));
  };

  refuse({"--model", "magic"}, "bssrdf, volume");
  refuse({"--samples", "0"}, "--samples");
  refuse({"--noise", "0"}, "--noise");
  refuse({"--noise", "nan"}, "--noise");
  refuse({"--threads", "-1"}, "--threads");
  refuse({"--exposure", "auto"}, "give the reference the number");
  refuse({"--tone-map", "pretty"}, "natural, neutral, agx, filmic, srgb, linear");
  refuse({"--camera", "none"}, "--camera");
  refuse({"--size", "0x5"}, "--size");
  refuse({"--size", "65536x65536"}, "pixels");
  refuse({"--model", "volume"}, "needs a medium");
  refuse({"--model", "volume", "--medium", "cheese"}, "skin1");
  refuse({"--model", "volume", "--medium", "sigma_a=1"}, "sigma_s");
  refuse({"--model", "volume", "--medium", "sigma_a=-1 sigma_s=1"}, "sigma_a");
  refuse({"--variance", in_folder("v.png")}, ".exr");
  refuse({"--environment", in_folder("nowhere.hdr")}, "no such environment");
  refuse({"--set", "lighting.environment_intensity=-1"}, "lighting.environment_intensity");
  refuse({"--variance", in_folder("r.exr")}, "its own");
  refuse({"--stats", in_folder("r.exr")}, "its own");
  const auto with = [&](const std::string& text) {
    return file("wrong.json", R"({"reference": )" + text + "}");
  };
  refuse({"--settings", with(R"({"samples": 0})")}, "reference.samples");
  refuse({"--settings", with(R"({"model": "magic"})")}, "bssrdf, volume");
  refuse({"--settings", with(R"({"seed": 1.5})")}, "reference.seed");
  refuse({"--settings", with(R"({"seed": -1})")}, "reference.seed");
  refuse({"--settings", with(R"({"checkpoint": "a"})")}, "threads");

  expect_refused(run({"reference", head(), "-o", in_folder("a.bmp")}), ".bmp");
  expect_not_understood(reference("r.exr", {"--technique", "lambert"}), "--technique");

  file("r.exr.resume", "rubbish");
  expect_refused(reference("r.exr", {"--resume", "--samples", "1"}), "not a checkpoint");
}

}  // namespace
}  // namespace dermis::tests
