// SPDX-License-Identifier: MIT
// `dermis compare --scene`: its table, its JSON, its page, and what it refuses.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class CompareScene : public Program {
 protected:
  std::string head() const { return file("head.gltf", tiny_gltf()); }
  std::string in_folder(const std::string& name) const { return (folder() / name).string(); }
  Result compare(const Arguments& arguments) const {
    Arguments all{"compare", "--scene", head()};
    const auto given = [&](const char* name) {
      return std::find(arguments.begin(), arguments.end(), name) != arguments.end();
    };
    if (!given("--size")) all.insert(all.end(), {"--size", "24x24"});
    if (!given("--samples")) all.insert(all.end(), {"--samples", "16"});
    if (!given("--map-size")) all.insert(all.end(), {"--map-size", "64"});
    all.insert(all.end(), {"--shadow-size", "64", "--frames", "1"});
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(all);
  }
  json found(Arguments arguments) const {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Result result = compare(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out, nullptr, false);
  }
};

TEST_F(CompareScene, EveryTechniqueCostAndErrorPerRegion) {
  const json j = found({"--light", "0,40"});
  ASSERT_TRUE(j.is_object());
  EXPECT_EQ(j.at("size"), json({24, 24}));
  EXPECT_EQ(j.at("lights"), 1);
  EXPECT_EQ(j.at("supersample"), 4);
  EXPECT_EQ(j.at("reference").at("model"), "bssrdf");
  EXPECT_EQ(j.at("reference").at("samples"), 16);
  EXPECT_GT(j.at("reference").at("noise_percent"), 0);

  std::vector<std::string> names, empty;
  for (const json& region : j.at("regions")) {
    names.push_back(region.at("name"));
    if (region.at("pixels") == 0) empty.push_back(names.back());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"skin", "ears", "nose", "terminator", "shadow edges",
                                             "thin parts", "folds", "seams", "the rest"}));
  EXPECT_GE(std::count(empty.begin(), empty.end(), "ears") + std::count(empty.begin(), empty.end(), "nose"),
            2)
      << "a plane has neither";

  std::vector<std::string> techniques;
  for (const json& t : j.at("techniques")) {
    techniques.push_back(t.at("name"));
    EXPECT_GT(t.at("frame_ms").at("median"), 0);
    for (const std::string& name : names) {
      const json& e = t.at("error").at(name);
      const bool is_empty = std::count(empty.begin(), empty.end(), name) > 0;
      EXPECT_EQ(e.is_null(), is_empty) << name;
      if (is_empty) continue;
      for (const char* key : {"flip", "hdr_flip", "psnr_db", "rel_mse", "rel_mse_unbiased", "share"})
        EXPECT_TRUE(e.at(key).is_number()) << key;
    }
    EXPECT_EQ(t.at("error").at("skin").at("share"), 1);
  }

  EXPECT_EQ(techniques, (std::vector<std::string>{"texture-space", "texture-space, one Gaussian", "lambert",
                                                  "screen-gaussians", "separable", "burley-disc",
                                                  "pre-integrated", "published", "published, one Gaussian"}));
  EXPECT_EQ(j.at("techniques")[0].at("gaussians"), 6);
  EXPECT_EQ(j.at("techniques")[1].at("gaussians"), 1);
  EXPECT_EQ(j.at("techniques")[2].at("gaussians"), 0);
  EXPECT_GT(j.at("noise").at("skin").at("flip"), 0);
}

TEST_F(CompareScene, AReferenceThatIsThereIsUsedAgain) {
  const Result made = run({"reference", head(), "--size", "24x24", "--samples", "16", "-o",
                           in_folder("truth.exr"), "--variance", in_folder("v.exr")});
  ASSERT_EQ(made.status, 0) << made.err;

  json now = found({"--techniques", "lambert"}),
       again = found({"--techniques", "lambert", "--reference", in_folder("truth.exr"), "--variance",
                      in_folder("v.exr")});
  EXPECT_EQ(again.at("reference"), json({{"file", in_folder("truth.exr")}}));
  EXPECT_EQ(now.at("techniques")[0].at("error"), again.at("techniques")[0].at("error"));
  EXPECT_EQ(now.at("noise"), again.at("noise"));
  EXPECT_TRUE(
      found({"--techniques", "lambert", "--reference", in_folder("truth.exr")}).at("noise").is_null());

  expect_refused(compare({"--size", "25x24", "--reference", in_folder("truth.exr")}), "say 25 x 24");
  expect_refused(compare({"--reference", in_folder("none.exr")}), "no such file");
  expect_refused(compare({"--reference", file("text.exr", "no picture")}), "text.exr");
  expect_refused(compare({"--reference", in_folder("truth.exr"), "--html", in_folder("truth.exr")}),
                 "names of their own");
  expect_refused(compare({"--reference", in_folder("truth.exr"), "--variance", in_folder("v.exr"), "--json",
                          in_folder("v.exr")}),
                 "names of their own");
  expect_not_understood(compare({"--variance", in_folder("v.exr")}), "--reference");
}

TEST_F(CompareScene, EachOptimisationAndAPage) {
  const Result result = compare({"--techniques", "texture-space", "--each-optimisation", "--supersample", "1",
                                 "--html", in_folder("page.html"), "--json", in_folder("n.json")});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");

  std::vector<json> optimised;
  const json numbers = json::parse(read_text(folder() / "n.json"));
  for (const json& t : numbers.at("techniques")) optimised.push_back(t.at("optimise"));
  EXPECT_EQ(optimised, (std::vector<json>{{"cull", "depth", "clip"},
                                          json::array(),
                                          {"cull"},
                                          {"depth"},
                                          {"clip"},
                                          {"cull", "depth", "clip"}}));

  EXPECT_NE(result.out.find("texture-space, --optimise cull"), std::string::npos);
  EXPECT_NE(result.out.find("ears: empty"), std::string::npos);

  const std::string page = read_text(folder() / "page.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_NE(page.find("class=\"slider\""), std::string::npos);
}

TEST_F(CompareScene, CurvesHaveThePointsThatATechniqueCanDraw) {
  const json j = found({"--techniques", "separable,lambert", "--curves", "--supersample", "1", "--model",
                        "gaussians", "--size", "16x16"});
  EXPECT_EQ(j.at("reference").at("model"), "gaussians");
  std::vector<std::string> labels;
  for (const json& p : j.at("curves")) {
    labels.push_back(p.at("curve").get<std::string>() + ": " + p.at("setting").get<std::string>());
    EXPECT_GT(p.at("frame_ms"), 0);
    EXPECT_EQ(p.at("error"), p.at("at_size")) << "one picture per pixel";
  }
  std::vector<std::string> wanted;
  for (const char* kernel : {"profile", "published"})
    for (const int taps : {5, 7, 9, 13, 17, 25, 33})
      wanted.push_back(fmt::format("separable, kernel {}: {} taps", kernel, taps));
  wanted.emplace_back("lambert: lambert");
  EXPECT_EQ(labels, wanted);
  EXPECT_EQ(j.at("curves")[5].at("taps_per_pixel"), 50) << "25 in each of two passes";
  EXPECT_EQ(j.at("techniques")[0].at("taps_per_pixel"), 50);
  EXPECT_EQ(j.at("techniques")[1].at("taps_per_pixel"), 0);
}

// Two sizes, two distances, one generated scene; its own camera and light, at the smaller size.
TEST_F(CompareScene, ATableOfCases) {
  const Arguments table{"--table",
                        "--sizes",
                        "24x24,16x16",
                        "--distances",
                        "3,6",
                        "--test-scenes",
                        "tilt-60,fringe",
                        "--techniques",
                        "separable,lambert",
                        "--supersample",
                        "1",
                        "--samples",
                        "2",
                        "--html",
                        in_folder("table.html")};
  Arguments all = table;
  all.insert(all.end(), {"--json", in_folder("table.json")});
  const Result result = compare(all);
  ASSERT_EQ(result.status, 0) << result.err;
  const json j = json::parse(read_text(folder() / "table.json"));
  std::vector<std::string> names;
  for (const json& one : j.at("cases")) names.push_back(one.at("name"));
  EXPECT_EQ(names,
            (std::vector<std::string>{"24x24, 3 radii", "24x24, 6 radii", "16x16, 3 radii", "16x16, 6 radii",
                                      "test:tilt-60", "test:fringe, --msaa 4", "test:fringe, --msaa 1"}));
  EXPECT_EQ(j.at("cases")[4].at("comparison").at("size"), json({16, 16}));
  EXPECT_EQ(j.at("cases")[4].at("comparison").at("lights"), 1);
  EXPECT_NE(j.at("cases")[5].at("comparison").at("techniques")[0].at("error"),
            j.at("cases")[6].at("comparison").at("techniques")[0].at("error"))
      << "samples make a difference at silhouettes";
  EXPECT_EQ(j.at("verdict").size(), names.size() + 2);
  EXPECT_NE(result.out.find("separable"), std::string::npos);
  EXPECT_TRUE(read_text(folder() / "table.html").starts_with("<!doctype html>"));
}

TEST_F(CompareScene, WhatATableCannotHave) {
  const auto refuse = [&](Arguments arguments, const std::string& says) {
    arguments.insert(arguments.begin(), "--table");
    expect_refused(compare(arguments), says);
  };
  refuse({"--distance", "3"}, "--distances");
  refuse({"--sizes", "10x"}, "expected WIDTHxHEIGHT");
  refuse({"--sizes", "0x10"}, "output.width");
  refuse({"--distances", "-1"}, "camera.distance");
  refuse({"--test-scenes", "moon"}, "all, none, tilt-0, tilt-30");
  refuse({"--techniques", "oil"}, "all, texture-space");
  expect_not_understood(compare({"--sizes", "10x10"}), "--table");
}

// Every test scene that needs no head: a picture, the truth, and an error of both.
TEST_F(CompareScene, TestScenesAreGenerated) {
  for (const std::string name : {"tilt-0", "tilt-75", "nose", "outside", "thin-ear", "open-curl", "fringe"}) {
    SCOPED_TRACE(name);
    const Result result = run({"compare", "--scene", "test:" + name, "--techniques", "texture-space,lambert",
                               "--size", "32x18", "--samples", "64", "--map-size", "256", "--shadow-size",
                               "256", "--supersample", "1", "--frames", "1", "--json", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    const json j = json::parse(result.out, nullptr, false);
    EXPECT_EQ(j.at("scene"), "test:" + name);
    EXPECT_EQ(j.at("lights"), 1);
    EXPECT_GT(j.at("regions")[0].at("pixels"), 10);
    EXPECT_GT(j.at("techniques")[1].at("error").at("skin").at("rel_mse"),
              j.at("techniques")[0].at("error").at("skin").at("rel_mse"))
        << "without scattering the error is larger";
  }
  expect_refused(run({"compare", "--scene", "test:moon"}), "tilt-0, tilt-30");
  expect_refused(run({"compare", "--scene", "test:nose", "--unit-scale", "2"}), "is generated");
  expect_refused(run({"render", "test:nose", "--save-scene", in_folder("s.json"), "--size", "8x8", "-o",
                      in_folder("a.png")}),
                 "test:nose");
}

// Before the reference takes its time.
TEST_F(CompareScene, ATechniqueThatCannotDrawIsLeftOutOfAll) {
  const Result all = compare({"--set", "quality.taps=64", "--supersample", "1", "--json", "-"});
  ASSERT_EQ(all.status, 0) << all.err;
  EXPECT_NE(all.err.find("technique 'separable' is left out: "), std::string::npos) << all.err;
  const json numbers = json::parse(all.out, nullptr, false);
  std::vector<std::string> names;
  for (const json& t : numbers.at("techniques")) names.push_back(t.at("name"));
  EXPECT_EQ(std::count(names.begin(), names.end(), "separable"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "burley-disc"), 1);

  expect_refused(compare({"--techniques", "lambert,separable", "--set", "quality.taps=64"}), "taps");
}

TEST_F(CompareScene, WhatMakesNoSense) {
  const auto refuse = [&](const Arguments& arguments, const std::string& says) {
    SCOPED_TRACE(arguments[0] + " " + arguments[1]);
    expect_refused(compare(arguments), says);
  };

  refuse({"--techniques", "oil"},
         "all, texture-space, lambert, screen-gaussians, separable, burley-disc, pre-integrated, published");
  refuse({"--techniques", "all,lambert"}, "'all'");
  refuse({"--supersample", "0"}, "--supersample");
  refuse({"--supersample", "17"}, "--supersample");
  refuse({"--supersample", "16", "--size", "8192x8"}, "supersample (--supersample) must be at most 8");
  refuse({"--samples", "0"}, "--samples");
  refuse({"--noise", "-1"}, "--noise");
  refuse({"--model", "magic"}, "bssrdf, volume");
  refuse({"--model", "volume"}, "needs a medium");
  refuse({"--msaa", "3"}, "quality.samples (--msaa) must be 1 or 4");
  refuse({"--map-size", "0"}, "--map-size");
  refuse({"--exposure", "auto", "--reference", "truth.exr"}, "give the number");
  refuse({"--tone-map", "sepia"}, "natural, neutral, agx, filmic, srgb, linear");
  refuse({"--camera", "none"}, "--camera");
  refuse({"--device", "abacus"}, "there are: 0: ");
  refuse({"--distance", "1000000"}, "shows no skin");
  refuse({"--light", "0,100"}, "elevation");
  refuse({"--html", "-"}, "needs a file");

  expect_refused(run({"compare", "--scene", in_folder("none.gltf")}), "none.gltf");
  expect_refused(compare({"--json", in_folder("head.gltf")}), "names of their own");
}

TEST_F(CompareScene, EitherTwoPicturesOrAScene) {
  const std::string scene = head();
  expect_not_understood(run({"compare"}), "--scene");
  expect_not_understood(run({"compare", "--scene", scene, "a.png", "b.png"}), "--scene");
  expect_not_understood(run({"compare", "a.png", "b.png", "--size", "10x10"}), "--scene");
  expect_not_understood(run({"compare", "a.png", "b.png", "--light", "0,0"}), "--scene");
  expect_not_understood(run({"compare", "--scene", scene, "--region", "r.png"}), "--region");
  expect_not_understood(run({"compare", "--scene", scene, "--z", "v.exr"}), "--z");
  expect_not_understood(run({"compare", "--scene", scene, "--heads", "2"}), "--heads");
  expect_not_understood(run({"compare", "--scene", scene, "--bloom", "0"}), "--bloom");
}

}  // namespace
}  // namespace dermis::tests
