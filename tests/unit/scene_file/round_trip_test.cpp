// SPDX-License-Identifier: MIT
// What a scene file says of a scene is all of it, to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>

#include "api/prepare/scene_file.h"
#include "api/scene_state.h"
#include "dermis/error.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

Asset asset_of(const fs::path& file, const SceneOptions& options = {}) {
  auto data = std::make_shared<scene::AssetData>();
  data->name = file.empty() ? "built-in" : file.filename().string();
  return Asset::State::make(std::move(data), Asset::State::Source{.file = file, .options = options});
}

api::SceneFile read(const std::string& text, const fs::path& path, const SceneOptions& options = {}) {
  return api::read_scene_file(json::Document(text, path.string()).root(), path, options);
}

// Numbers whose shortest decimal form is long.
std::array<double, 16> odd_transform() {
  const double c = std::cos(0.7) * 0.9, s = std::sin(0.7) * 0.9;
  return {c, 0, -s, 0, 0, 0.9, 0, 0, s, 0, c, 0, 1.0 / 3, -1e-7, std::numbers::pi * 1e3, 1};
}

Scene whole_scene() {
  Scene scene;
  const Asset head = asset_of("/heads/a/head.glb", {.unit_scale = 0.1, .skin_material = {"face", "*ear*"}});
  const InstanceId first = scene.add({.asset = head, .name = "left", .world_from_asset = odd_transform()});
  scene.add({.asset = asset_of({}),
             .name = "twin",
             .visible = false,
             .profile = ScatterProfile{.name = "made up",
                                       .model = "none",
                                       .terms = {{1.0 / 7, {0.4, 1.0 / 3, 0.6}}, {2.5, {0.6, 2.0 / 3, 0.4}}},
                                       .total_reflectance = {0.7, 0.6, 0.5}},
             .mix = 0.1,
             .tint = {0.8, 0.7, 1.0 / 3}});
  const InstanceId third = scene.add({.asset = head, .name = "twin"});
  scene.add_light({.light = {.name = "key",
                             .type = LightType::spot,
                             .colour = {1, 0.9, 0.1 + 0.2},
                             .position_m = {1, 2, 3},
                             .direction = {0, -1, -1},
                             .range_m = 7,
                             .inner_cone_deg = 10,
                             .outer_cone_deg = 90,
                             .radius = 0.02},
                   .rig = first});
  scene.add_light({.light = {.type = LightType::point}, .rig = third});
  scene.add_light({.light = {.type = LightType::directional, .direction = {-1, 0, 0}}});
  scene.set_environment(SceneEnvironment{.file = "studio"});
  return scene;
}

void expect_equal(const Instance& a, const Instance& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.world_from_asset, b.world_from_asset);
  EXPECT_EQ(a.visible, b.visible);
  EXPECT_EQ(a.mix, b.mix);
  EXPECT_EQ(a.tint, b.tint);
  ASSERT_EQ(a.profile.has_value(), b.profile.has_value());
  if (!a.profile) return;
  EXPECT_EQ(a.profile->name, b.profile->name);
  EXPECT_EQ(a.profile->model, b.profile->model);
  EXPECT_EQ(a.profile->terms, b.profile->terms);
  EXPECT_EQ(a.profile->total_reflectance, b.profile->total_reflectance);
}

TEST(SceneFile, HoldsAllOfAScene) {
  const Scene scene = whole_scene();
  const std::string text = api::scene_file_text(scene, "/heads/scene.json");
  const api::SceneFile file = read(text, "/heads/scene.json");

  ASSERT_EQ(file.assets.size(), 2u);
  EXPECT_EQ(file.assets[0].file, "/heads/a/head.glb");
  EXPECT_EQ(file.assets[0].options.unit_scale, 0.1);
  EXPECT_EQ(file.assets[0].options.skin_material, (std::vector<std::string>{"face", "*ear*"}));
  EXPECT_TRUE(file.assets[1].file.empty());
  EXPECT_EQ(file.asset_of_instance, (std::vector<std::size_t>{0, 1, 0}));

  const std::vector<InstanceId> ids = scene.instances(), read_ids = file.scene.instances();
  ASSERT_EQ(read_ids.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) expect_equal(scene.instance(ids[i]), file.scene.instance(read_ids[i]));

  const std::vector<LightId> lights = scene.lights(), read_lights = file.scene.lights();
  ASSERT_EQ(read_lights.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(scene.light(lights[i]).light, file.scene.light(read_lights[i]).light) << i;
  EXPECT_EQ(file.scene.light(read_lights[0]).rig, read_ids[0]);
  EXPECT_EQ(file.scene.light(read_lights[1]).rig, read_ids[2]) << "of two that share a name";
  EXPECT_FALSE(file.scene.light(read_lights[2]).rig);
  EXPECT_EQ(file.scene.environment()->file, "studio");
}

TEST(SceneFile, OfAnEmptySceneIsOne) {
  const api::SceneFile file = read(api::scene_file_text({}, "/a/scene.json"), "/a/scene.json");
  EXPECT_TRUE(file.scene.instances().empty());
  EXPECT_FALSE(file.scene.environment());
}

TEST(SceneFile, ListsAnAssetOnceAndNamesDifferentOnesApart) {
  Scene scene;
  for (const char* file : {"/x/head.glb", "/y/head.glb", "/x/head.glb"}) scene.add({.asset = asset_of(file)});
  scene.add({.asset = asset_of("/x/head.glb", {.unit_scale = 2})});
  const api::SceneFile file = read(api::scene_file_text(scene, "/x/s.json"), "/x/s.json");
  ASSERT_EQ(file.assets.size(), 3u);
  EXPECT_EQ(file.asset_of_instance, (std::vector<std::size_t>{0, 1, 0, 2}));
  EXPECT_EQ(file.assets[1].file.lexically_normal(), "/y/head.glb");
  EXPECT_EQ(file.assets[2].options.unit_scale, 2);
}

TEST(SceneFile, NamesItsFilesFromWhereItLies) {
  const auto named = [](const char* asset, const char* scene_file) {
    Scene scene;
    scene.add({.asset = asset_of(asset)});
    const std::string text = api::scene_file_text(scene, scene_file);
    const std::size_t begin = text.find("\"file\":\"") + 8;
    return text.substr(begin, text.find('"', begin) - begin);
  };
  EXPECT_EQ(named("/none/heads/a.glb", "/none/scene.json"), "heads/a.glb");
  EXPECT_EQ(named("/none/heads/a.glb", "/none/scenes/s.json"), "../heads/a.glb");
  EXPECT_EQ(named("/none/heads/a.glb", "/other/s.json"), "/none/heads/a.glb") << "nothing in common";

  Scene scene;
  scene.set_environment(SceneEnvironment{.file = "/none/studio"});
  const api::SceneFile file = read(api::scene_file_text(scene, "/none/s.json"), "/none/s.json");
  EXPECT_EQ(fs::path(file.scene.environment()->file).lexically_normal(), "/none/studio")
      << "a file is not the studio that is built in";
}

TEST(SceneFile, ThatCannotBeIsRefused) {
  Scene scene;
  scene.add({.asset = asset_of({})});
  scene.add({.asset = Asset::State::make(
                 std::make_shared<const scene::AssetData>(scene::AssetData{.name = "mine"})),
             .name = "left"});
  const auto refused = [&] {
    return thrown<InputError>([&] { api::scene_file_text(scene, "/a/scene.json"); });
  };
  EXPECT_NE(refused().find("instance 1 ('left'): its asset 'mine' was made in memory"), std::string::npos)
      << refused();

  scene = Scene();
  auto rgb = std::make_shared<std::vector<float>>(6, 1.0f);
  scene.set_environment(SceneEnvironment{.width = 2, .height = 1, .rgb = rgb});
  EXPECT_NE(refused().find("the environment of this scene was made in memory"), std::string::npos)
      << refused();

  scene = Scene();
  scene.add({.asset = asset_of("/a/scene.json")});
  EXPECT_NE(refused().find("is the file of an asset"), std::string::npos) << refused();

  scene = Scene();
  scene.add({.asset = asset_of({}), .name = "\xff"});
  EXPECT_NE(refused().find("not UTF-8"), std::string::npos) << refused();

  // A glTF file may have such a light.
  auto glaring = std::make_shared<scene::AssetData>();
  glaring->lights.push_back({.name = "sun", .colour = glm::vec3(1e10f)});
  scene = Scene(Asset::State::make(std::move(glaring), Asset::State::Source{}));
  EXPECT_NE(refused().find("lights[0]: light.colour must be 0 to 1e9"), std::string::npos) << refused();
}

TEST(SceneFile, IsWrittenWholeOrNotAtAll) {
  const TempFolder folder;
  const fs::path path = folder.path() / "scene.json";
  Scene().save(path);
  const std::string text = read_text(path);

  Scene scene;
  scene.add({.asset = Asset::State::make(std::make_shared<const scene::AssetData>())});
  EXPECT_THROW(scene.save(path), InputError);
  EXPECT_EQ(read_text(path), text);
  EXPECT_THROW(Scene().save(folder.path() / "none" / "scene.json"), InputError);
  EXPECT_EQ(Scene::load(path).name(), "scene.json");
}

}  // namespace
}  // namespace dermis::tests
