// SPDX-License-Identifier: MIT
// Several files in one picture, and scene files: what --save-scene writes gives the same picture again.
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

using nlohmann::json;

class SceneFiles : public Program {
 protected:
  std::string small() const { return file("small.gltf", tiny_gltf()); }
  std::string large() const {
    TinyMesh mesh;
    for (float& x : mesh.positions) x *= 2;
    return file("large.gltf", tiny_gltf(mesh, [](json& root) {
                  root["accessors"][0]["min"] = {-0.2, -0.2, 0}, root["accessors"][0]["max"] = {0.2, 0.2, 0};
                }));
  }
  std::string saved() const { return (folder() / "saved.json").string(); }
  json saved_scene() const { return json::parse(read_text(saved())); }

  /// The picture in linear light, so that equal pictures are equal to the bit.
  std::string rendered(Arguments arguments) const {
    const std::filesystem::path exr = folder() / "picture.exr";
    arguments.insert(arguments.begin(),
                     {"render", "-o", exr.string(), "--map-size", "64", "--shadow-size", "64"});
    arguments.insert(arguments.end(), {"--size", "64x48"});
    const Result result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
    return read_text(exr);
  }
  void refuse(const Arguments& arguments, const std::string& says) const {
    SCOPED_TRACE(says);
    expect_refused(render(arguments), says);
  }
};

double shift_of(const json& scene, std::size_t instance, std::size_t axis) {
  return scene["instances"][instance]["world_from_asset"][12 + axis].get<double>();
}

TEST_F(SceneFiles, GiveTheSamePictureAgain) {
  const std::string several =
      rendered({small(), large(), small(), large(), "--layout", "grid", "--save-scene", saved()});
  EXPECT_EQ(rendered({saved()}), several);
  const std::string text = read_text(saved());
  EXPECT_EQ(rendered({saved(), "--save-scene", saved()}), several);
  EXPECT_EQ(read_text(saved()), text);

  const json scene = saved_scene();
  EXPECT_EQ(scene["assets"].size(), 2u);
  EXPECT_EQ(scene["instances"].size(), 4u);
}

TEST_F(SceneFiles, OfOneFileHasItsLightsAndCameras) {
  const std::string head =
      file("head.gltf", tiny_gltf({}, [](json& root) {
             root["extensionsUsed"] = {"KHR_lights_punctual"};
             root["extensions"]["KHR_lights_punctual"]["lights"] = {
                 {{"type", "spot"}, {"spot", {{"outerConeAngle", 1.5707963267948966}}}, {"intensity", 0.3}}};
             root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}};
             root["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                                      {"camera", 0},
                                      {"translation", {0.05, 0.02, 0.6}}});
             root["scenes"][0]["nodes"].push_back(1);
           }));
  const std::string picture = rendered({head, "--save-scene", saved()});
  EXPECT_EQ(rendered({saved()}), picture);
  EXPECT_NE(rendered({saved(), "--lights", "2"}), picture);
  EXPECT_NE(rendered({saved(), "--orbit", "5,0"}), picture);
}

// As --heads places them, where all are alike.
TEST_F(SceneFiles, ARowOfOneFileIsThatOfHeads) {
  const std::string head = small();
  const Arguments camera{"--eye", "0.1,0.05,2", "--target", "0,0,0"};
  const auto with = [&](Arguments arguments) {
    arguments.insert(arguments.end(), camera.begin(), camera.end());
    return rendered(arguments);
  };
  EXPECT_EQ(with({head, head, head}), with({head, "--heads", "3"}));
  EXPECT_NE(with({head, head, head}), with({head, head, head, "--layout", "grid"}));
}

// Wherever their files have them.
TEST_F(SceneFiles, NeighboursStandByTheLargerOne) {
  TinyMesh mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) mesh.positions[i] += i % 3 == 0 ? 5.0f : -1.0f;
  const std::string moved =
      file("moved.gltf", tiny_gltf(mesh, [](json& root) {
             root["accessors"][0]["min"] = {4.9, -1.1, -1}, root["accessors"][0]["max"] = {5.1, -0.9, -1};
           }));
  rendered({small(), large(), moved, "--layout", "row", "--save-scene", saved()});

  const double step_m = 1.6 * 0.2 * std::sqrt(2.0);
  const std::array<double, 3> expected[] = {{-step_m, 0, 0}, {0, 0, 0}, {step_m - 5, 1, 1}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(shift_of(saved_scene(), i, axis), expected[i][axis], 1e-5) << i << " " << axis;
}

// One asset takes less memory of the device than two that are alike.
TEST_F(SceneFiles, AFileThatIsGivenTwiceIsOneAsset) {
  const std::string head = small(), copy = file("copy.gltf", tiny_gltf());
  const auto bytes = [&](const std::string& other) {
    const Result result = render({head, other, "--stats", "-"});
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out)["memory_bytes"]["buffers"].get<std::int64_t>();
  };
  EXPECT_LT(bytes(head), bytes(copy));
  EXPECT_EQ(bytes(head), bytes((folder() / "." / "small.gltf").string()));
}

TEST_F(SceneFiles, AreTakenByOtherCommands) {
  rendered({small(), large(), "--save-scene", saved()});
  const Result plan = run({"plan", saved(), "--map-size", "64"});
  EXPECT_EQ(plan.status, 0) << plan.err;
  EXPECT_EQ(run({"plan", small(), large(), "--map-size", "64"}).out, plan.out);

  const std::string mixed = file("mixed.json", R"({"dermis_scene": 1,
    "assets": [{"built_in": true}, {"file": "small.gltf"}],
    "instances": [{"asset": "built-in"}, {"asset": "small.gltf", "translation_m": [0.4, 0, 0]}],
    "lights": [{"type": "point", "position_m": [0, 0, 1], "rig": 1}],
    "environment": "studio"})");
  const Result of_both = run({"plan", mixed, "--map-size", "64"});
  EXPECT_EQ(of_both.status, 0) << of_both.err;
  EXPECT_NE(of_both.out.find("'stretch part 1'"), std::string::npos) << of_both.out;

  const std::string truth = (folder() / "truth.exr").string();
  const Result reference = run({"reference", saved(), "--samples", "1", "--size", "16x12", "-o", truth});
  EXPECT_EQ(reference.status, 0) << reference.err;
  const std::string of_file = read_text(truth);
  run({"reference", small(), large(), "--samples", "1", "--size", "16x12", "-o", truth});
  EXPECT_EQ(read_text(truth), of_file);
}

TEST_F(SceneFiles, SettingsStandBesideThem) {
  const std::string settings = (folder() / "settings.json").string();
  const std::string picture =
      rendered({small(), large(), "--unit-scale", "0.5", "--set", "skin.mix=0.9", "--orbit", "30,0",
                "--save-scene", saved(), "--save-settings", settings});
  EXPECT_EQ(rendered({saved(), "--settings", settings}), picture);
}

TEST_F(SceneFiles, WhatMakesNoSenseIsRefused) {
  const std::string a = small(), b = large();
  refuse({a, b, "--layout", "tower"}, "--layout 'tower' is not known; there are: row, grid");
  refuse({a, "--layout", "row"}, "--layout: places several files beside each other, and there is one");
  refuse({"--layout", "row"}, "and there is none");
  refuse({a, b, "--heads", "3"}, "camera.heads (--heads) must be 1 for several files, got 3");
  refuse({a, (folder() / "missing.glb").string()}, "missing.glb: no such file");
  expect_not_understood(run({"bench", a, b}), b);
  expect_not_understood(run({"render", a, "-o", picture().string(), "--layout"}), "--layout");

  const std::string scene = file("scene.json", R"({"dermis_scene": 1, "instances": []})");
  refuse({scene}, "scene.json: has no instances");
  refuse({a, scene}, "scene.json: is a scene file, and an asset is glTF; give a scene file alone");
  refuse({file("cut.json", R"({"dermis_scene": 1, "instances")")}, "cut.json: is not valid JSON");
  refuse({file("gone.json", R"({"dermis_scene": 1, "assets": [{"file": "gone.glb"}],)"
                            R"("instances": [{"asset": "gone.glb"}]})")},
         "gone.glb: no such file");

  rendered({a, b, "--save-scene", saved()});
  refuse({saved(), "--heads", "2"}, "camera.heads (--heads) must be 1 for a scene of 2 instances, got 2");
}

TEST_F(SceneFiles, AreNotWrittenOverOtherFiles) {
  const std::string a = small(), text = read_text(a);
  refuse({a, large(), "--save-scene", a}, "--save-scene needs its own");
  refuse({a, "--save-scene", picture().string()}, "--save-scene needs its own");
  refuse({a, "--save-scene", saved(), "--save-settings", saved()}, "--save-scene needs its own");
  refuse({a, "--save-scene", (folder() / "none" / "scene.json").string()}, "does not exist");
  EXPECT_EQ(read_text(a), text);
}

}  // namespace
}  // namespace dermis::tests
