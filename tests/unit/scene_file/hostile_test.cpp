// SPDX-License-Identifier: MIT
// Scene files that are wrong: one line that names the place. And those that may be written by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "api/prepare/scene_file.h"
#include "api/scene_state.h"
#include "dermis/error.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

api::SceneFile read(const std::string& text, const SceneOptions& options = {}) {
  const std::filesystem::path path = "/none/scene.json";
  return api::read_scene_file(json::Document(text, path.string(), api::scene_file_limits).root(), path,
                              options);
}

std::string with(const std::string& members) { return R"({"dermis_scene": 1, )" + members + "}"; }

// A scene of one instance of the built-in head, with these members.
std::string one(const std::string& members) {
  return with(R"("assets": [{"built_in": true}], "instances": [{"asset": "built-in", "name": "a"},)"
              R"( {"asset": "built-in")" +
              std::string(members.empty() ? "" : ", ") + members + "}]");
}

std::string lit(const std::string& light) {
  return with(R"("assets": [{"built_in": true}], "instances": [{"asset": "built-in", "name": "a"},)"
              R"({"asset": "built-in", "name": "b"}, {"asset": "built-in", "name": "b"}],)"
              R"("lights": [{)" +
              light + "}]");
}

void refuse(const std::string& text, const std::string& says) {
  const std::string said = thrown<InputError>([&] { read(text); });
  EXPECT_NE(said.find(says), std::string::npos)
      << "expected '" << says << "' in: " << said << "\nof " << text;
  EXPECT_NE(said.find("scene.json"), std::string::npos) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

Instance second(const std::string& members) {
  const api::SceneFile file = read(one(members));
  return file.scene.instance(file.scene.instances().at(1));
}

TEST(SceneFileByHand, NeedsLittle) {
  const Instance plain = second("");
  EXPECT_EQ(plain.world_from_asset, (std::array<double, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_TRUE(plain.visible);
  EXPECT_FALSE(plain.mix || plain.profile);
  EXPECT_EQ(second(R"("profile": "skin")").profile->name, "skin");
  EXPECT_FALSE(second(R"("profile": null)").profile);
}

TEST(SceneFileByHand, PlacesByParts) {
  // A quarter turn about +Y takes +X to -Z.
  const double half = std::sqrt(0.5);
  const Instance placed = second(
      fmt::format(R"("translation_m": [1, 2, 3], "rotation": [0, {}, 0, {}], "scale": 2)", half, half));
  const std::array<double, 16> expected{0, 0, -2, 0, 0, 2, 0, 0, 2, 0, 0, 0, 1, 2, 3, 1};
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(placed.world_from_asset[i], expected[i], 1e-15) << i;
  EXPECT_EQ(second(R"("scale": 0.5)").world_from_asset[5], 0.5);
}

TEST(SceneFileByHand, TakesOptionsForWhatItsAssetsDoNotSay) {
  const api::SceneFile file =
      read(with(R"("assets": [{"file": "a.glb"}, {"file": "b.glb", "unit_scale": 3}], "instances": [])"),
           {.unit_scale = 2});
  EXPECT_EQ(file.assets.at(0).options.unit_scale, 2);
  EXPECT_EQ(file.assets.at(1).options.unit_scale, 3);
  EXPECT_EQ(file.assets.at(0).file, "/none/a.glb");
}

// A clip or a time that is empty is none: a scene that was saved plays what a command says.
TEST(SceneFileByHand, HasPosesByClipAndTime) {
  const std::string assets =
      R"("assets": [{"file": "a.glb"}, {"file": "b.glb", "clip": "walk", "time_s": null},)"
      R"({"file": "c.glb", "clip": "", "time_s": 3}],)";
  const api::SceneFile file =
      read(with(assets + R"("instances": [{"asset": "a.glb"}, {"asset": "b.glb", "time_s": 2},)"
                         R"({"asset": "c.glb", "clip": "run", "time_s": -1.5}])"),
           {.clip = "talk", .time_s = 0.0});
  EXPECT_EQ(file.assets.at(0).options.clip, "talk");
  EXPECT_EQ(file.assets.at(1).options.clip, "walk");
  EXPECT_EQ(file.assets.at(1).options.time_s, 0.0);
  EXPECT_FALSE(file.assets.at(1).holds_time);
  EXPECT_EQ(file.assets.at(2).options.clip, "talk");
  EXPECT_EQ(file.assets.at(2).options.time_s, 3.0);
  EXPECT_TRUE(file.assets.at(2).holds_time);

  EXPECT_FALSE(file.pose_of_instance.at(0));
  EXPECT_EQ(file.pose_of_instance.at(1)->clip->clip, "");
  EXPECT_EQ(file.pose_of_instance.at(1)->clip->seconds, 2);
  EXPECT_EQ(file.pose_of_instance.at(2)->clip->clip, "run");
  EXPECT_EQ(file.pose_of_instance.at(2)->clip->seconds, -1.5);
}

TEST(SceneFileByHand, NamesARigByNameOrNumber) {
  const auto rig_of = [](const std::string& light) {
    const api::SceneFile file = read(lit(light));
    return file.scene.light(file.scene.lights().at(0)).rig == file.scene.instances().at(0);
  };
  EXPECT_TRUE(rig_of(R"("rig": "a")"));
  EXPECT_TRUE(rig_of(R"("rig": 0)"));
  EXPECT_FALSE(rig_of(R"("rig": 2)"));
}

TEST(SceneFileByHand, IsAsTheDocsShowIt) {
  const std::string page = read_text(std::filesystem::path(DERMIS_SOURCE_DIR) / "docs" / "scenes.md");
  const std::size_t begin = page.find("```json\n") + 8;
  const api::SceneFile file = read(page.substr(begin, page.find("\n```", begin) - begin));
  EXPECT_EQ(file.scene.instances().size(), 2u);
  EXPECT_EQ(file.scene.lights().size(), 1u);
}

TEST(HostileSceneFile, TheTop) {
  refuse("", "is not valid JSON");
  refuse("[]", "must be an object");
  refuse("{}", "'dermis_scene' is missing");
  refuse(R"({"dermis_scene": 1})", "'instances' is missing");
  refuse(R"({"dermis_scene": "1", "instances": []})", "dermis_scene: must be an integer");
  refuse(R"({"dermis_scene": 0, "instances": []})", "dermis_scene: must be 1");
  refuse(R"({"dermis_scene": 2, "instances": []})", "newer than this program");
  refuse(R"({"dermis_scene": 1e300, "instances": []})", "dermis_scene");
  refuse(R"({"dermis_scene": 1, "dermis_scene": 1, "instances": []})", "given twice");
  refuse(with(R"("instances": [], "cameras": [])"), "unknown key 'cameras'; there are: dermis_scene, assets");
  refuse(with(R"("instances": {})"), "instances: must be an array");
  refuse(with(R"("instances": [[]])"), "instances[0]: must be an object");
  refuse(with(R"("instances": [], "environment": 3)"), "environment: must be a string");
  refuse(with(R"("instances": [], "environment": "")"), "environment: must be the name of a file");
  refuse(with("\"instances\": " + std::string(20, '[') + std::string(20, ']')), "nested deeper");
  std::string many = "{}";
  for (int i = 0; i < 16384; ++i) many += ",{}";
  refuse(with("\"instances\": [" + many + "]"), "instances: must have 0 to 16384 elements, has 16385");
}

TEST(HostileSceneFile, Assets) {
  const auto assets = [](const std::string& list) {
    return with("\"assets\": [" + list + R"(], "instances": [])");
  };
  refuse(assets("{}"), "assets[0]: 'file' is missing");
  refuse(assets(R"({"file": ""})"), "assets[0].file: must be the name of a file");
  refuse(assets(R"({"file": "a\u0000.glb"})"), "assets[0].file: must be the name of a file");
  refuse(assets(R"({"file": 3})"), "assets[0].file: must be a string");
  refuse(assets(R"({"built_in": 1})"), "assets[0].built_in: must be true or false");
  refuse(assets(R"({"built_in": "pale"})"), "assets[0].built_in: must be true, light, medium or dark");
  refuse(assets(R"({"built_in": true, "file": "a.glb"})"), "unknown key 'file'");
  refuse(assets(R"({"file": "a.glb", "scale": 2})"), "unknown key 'scale'");
  refuse(assets(R"({"file": "a.glb", "unit_scale": -1})"), "assets[0].unit_scale");
  refuse(assets(R"({"file": "a.glb", "unit_scale": NaN})"), "is not valid JSON");
  refuse(assets(R"({"file": "a.glb"}, {"file": "a.glb"})"),
         "assets[1]: an asset called 'a.glb' stands before");
  refuse(assets(R"({"built_in": true}, {"file": "a.glb", "name": "built-in"})"), "'built-in' stands before");
}

TEST(HostileSceneFile, Instances) {
  refuse(with(R"("instances": [{}])"), "instances[0]: 'asset' is missing");
  refuse(with(R"("instances": [{"asset": "x"}])"), "no asset is called 'x'; the file has no assets");
  refuse(with(R"("assets": [{"file": "a.glb"}], "instances": [{"asset": "x"}])"), "there are: a.glb");
  refuse(one(R"("instances": [])"), "unknown key 'instances'");
  refuse(one(R"("visible": 1)"), "instances[1].visible: must be true or false");
  refuse(one(R"("mix": 2)"), "instances[1]: mix must be 0 to 1, got 2");
  refuse(one(R"("mix": "much")"), "instances[1].mix: must be a number");
  refuse(one(R"("tint": [1, 1])"), "instances[1].tint");
  refuse(one(R"("tint": [1, 1, -1])"), "instances[1]: tint must be 0 to 100, got -1");
  refuse(one(R"("tint": [1, 1, 1e300])"), "instances[1]: tint must be");
  refuse(one(R"("tint": [1, 1, 1e999])"), "is not valid JSON");
  refuse(one(R"("name": 3)"), "instances[1].name: must be a string");
  refuse(one(R"("clip": 3)"), "instances[1].clip: must be a string");
  refuse(one(R"("time_s": "now")"), "instances[1].time_s: must be a number");
  refuse(one(R"("time_s": 1e999)"), "is not valid JSON");
}

TEST(HostileSceneFile, Transforms) {
  const std::string rigid = "instances[1]: world_from_asset must be rigid with one positive scale";
  const auto matrix = [](const std::string& numbers) {
    return one("\"world_from_asset\": [" + numbers + "]");
  };
  refuse(matrix("1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0"), "instances[1].world_from_asset");
  refuse(matrix("1,0,0,0, 0,2,0,0, 0,0,1,0, 0,0,0,1"), rigid);
  refuse(matrix("-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1"), rigid);
  refuse(matrix("0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,1"), rigid);
  refuse(matrix("1,0,0,0, 0,1,0,0, 0,0,1,0, 1e300,0,0,1"), rigid);
  refuse(matrix("1e300,0,0,0, 0,1e300,0,0, 0,0,1e300,0, 0,0,0,1"), rigid);
  refuse(matrix("1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1"), rigid);
  refuse(one(R"("scale": 0)"), rigid);
  refuse(one(R"("scale": -1)"), rigid);
  refuse(one(R"("scale": null)"), "instances[1].scale: must be a number");
  refuse(one(R"("rotation": [0, 0, 0, 0])"), "instances[1].rotation: must be a quaternion");
  refuse(one(R"("rotation": [0, 0, 0, 2])"), "its length is 2");
  refuse(one(R"("rotation": [0, 90, 0])"), "instances[1].rotation: must have 4 numbers, has 3");
  refuse(one(R"("translation_m": [0, 0, 1e300])"), "instances[1].translation_m[2]");
  refuse(one(R"("scale": 1, "world_from_asset": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1])"), "one of them");
}

TEST(HostileSceneFile, Profiles) {
  refuse(one(R"("profile": 3)"), "instances[1].profile: must be a name, a file or an object");
  refuse(one(R"("profile": "")"), "instances[1].profile: must be the name of a file");
  refuse(one(R"("profile": "none.json")"), "'/none/none.json' is neither a file nor a known name");
  refuse(one(R"("profile": {"variances_mm2": [-1], "weights": [[1, 1, 1]]})"),
         "instances[1].profile.variances_mm2[0]");
  refuse(one(R"("profile": {"variances_mm2": [1], "weights": [[0.5, 1, 1]]})"), "sum to 0.5");
}

TEST(HostileSceneFile, Lights) {
  refuse(lit(R"("type": "sun")"), "lights[0].type: 'sun' is not known; there are: directional, spot, point");
  refuse(lit(R"("rig": "c")"), "lights[0].rig: no instance is called 'c'");
  refuse(lit(R"("rig": "b")"), "2 instances are called 'b'");
  refuse(lit(R"("rig": 3)"), "lights[0].rig");
  refuse(lit(R"("rig": -1)"), "lights[0].rig");
  refuse(lit(R"("rig": true)"), "lights[0].rig: must be an integer");
  refuse(lit(R"("colour": [1, 1, -1])"), "lights[0]: light.colour must be 0 to 1e9, got -1");
  refuse(lit(R"("colour": [1, 1, 1e300])"), "lights[0]: light.colour");
  refuse(lit(R"("direction": [0, 0, 0])"), "lights[0]: light.direction must be longer than 0");
  refuse(lit(R"("type": "spot", "inner_cone_deg": 50)"), "lights[0]: light.inner_cone_deg");
  refuse(lit(R"("type": "spot", "outer_cone_deg": 91)"), "lights[0]: light.outer_cone_deg");
  refuse(lit(R"("radius_m": 1)"), "unknown key 'radius_m'");
  refuse(with(R"("instances": [], "lights": [{"rig": 0}])"), "lights[0].rig: there are no instances");
}

// By its content, whatever it is called; a glTF file may hold the word.
TEST(SceneFileContent, IsWhatMakesOne) {
  const TempFolder folder;
  const auto is_one = [&](const std::string& content) {
    write_text(folder.path() / "file", content);
    return api::open_scene_file(folder.path() / "file").has_value();
  };
  EXPECT_TRUE(is_one(R"({"dermis_scene": 1, "instances": []})"));
  EXPECT_TRUE(is_one(" \n\t{\n \"instances\": [], \"dermis_scene\": 1}"));
  EXPECT_FALSE(is_one(""));
  EXPECT_FALSE(is_one("dermis_scene"));
  EXPECT_FALSE(is_one(R"({"asset": {"version": "2.0"}})"));
  EXPECT_FALSE(is_one(R"({"asset": {"version": "2.0"}, "extras": {"dermis_scene": 1}})"));
  EXPECT_FALSE(is_one(R"(["dermis_scene"])"));
  EXPECT_THROW(is_one(R"({"dermis_scene": 1, )"), InputError);
  EXPECT_FALSE(api::open_scene_file(folder.path()));
  EXPECT_FALSE(api::open_scene_file(folder.path() / "none"));
}

TEST(SceneFileContent, IsNoAsset) {
  const TempFolder folder;
  const auto path = folder.path() / "scene.json";
  write_text(path, R"({"dermis_scene": 1, "assets": [{"file": "scene.json"}], )"
                   R"("instances": [{"asset": "scene.json"}]})");
  for (const std::string& said :
       {thrown<InputError>([&] { Asset::load(path); }), thrown<InputError>([&] { Scene::load(path); })})
    EXPECT_NE(said.find("is a scene file, and an asset is glTF"), std::string::npos) << said;
}

}  // namespace
}  // namespace dermis::tests
