// SPDX-License-Identifier: MIT
// Cameras and lights at nodes of a file go with its clip, and what a command plays.
#include "../gltf/support.h"
#include "api/playing.h"
#include "api/scene_state.h"
#include "dermis/scene.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

// A triangle, a camera and a spot light at one node, which clip "0" moves by 2 m and clip "turn" turns.
struct Carrier : Builder {
  Carrier() {
    triangle();
    json["cameras"] =
        Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.01}}}}});
    json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array(
        {{{"type", "spot"}, {"intensity", 3}, {"spot", Json::object()}}, {{"type", "directional"}}});
    json["extensionsUsed"] = {"KHR_lights_punctual"};
    Json& node = json["nodes"][0];
    node["camera"] = 0;
    node["extensions"]["KHR_lights_punctual"]["light"] = 0;
    json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
    json["scenes"][0]["nodes"].push_back(1);
    const int times = accessor({0, 2}, "SCALAR");
    const auto clip = [&](const char* name, int values, const char* path) {
      return Json{{"name", name},
                  {"samplers", {{{"input", times}, {"output", values}}}},
                  {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}};
    };
    json["animations"] = {clip("move", accessor({0, 0, 0, 2, 0, 0}, "VEC3"), "translation"),
                          clip("turn", accessor({0, 0, 0, 1, 0, 0.6f, 0, 0.8f}, "VEC4"), "rotation")};
  }
};

class Views : public testing::Test {
 protected:
  static void expect_as(const dermis::Scene& found, const dermis::Scene& wanted) {
    const setup::PlacedScene a = api::placed_scene(found), b = api::placed_scene(wanted);
    const std::vector<Camera> cameras = placed_cameras(a), expected = placed_cameras(b);
    ASSERT_EQ(cameras.size(), 1u);
    for (glm::length_t c = 0; c < 4; ++c)
      EXPECT_LE(glm::distance(cameras[0].world_from_camera[c], expected[0].world_from_camera[c]), 1e-6);
    ASSERT_EQ(a.lights.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(glm::distance(a.lights[i].position_m, b.lights[i].position_m), 1e-6);
      EXPECT_LE(glm::distance(a.lights[i].direction, b.lights[i].direction), 1e-6);
    }
  }

  Warnings quiet_;
  TempFolder temp_;
  fs::path file_ = Carrier().write(temp_.path(), "carrier.glb");
};

TEST_F(Views, GoWithTheirNodes) {
  for (const char* clip : {"move", "turn"}) {
    dermis::Scene scene(Asset::load(file_));
    const InstanceId id = scene.instances().front();
    const std::uint64_t before = scene.light_changes();
    scene.pose(id, clip, 1.5);
    EXPECT_GT(scene.light_changes(), before);
    expect_as(scene, dermis::Scene(Asset::load(file_, {.clip = clip, .time_s = 1.5})));

    // What a scene file keeps of a light is where it stands.
    scene.save(temp_.path() / "scene.json");
    expect_as(dermis::Scene::load(temp_.path() / "scene.json"), scene);
    scene.set_pose(id, {});
    expect_as(scene, dermis::Scene(Asset::load(file_)));
  }
}

TEST_F(Views, AreTheCallersOnceTheyAreSet) {
  dermis::Scene scene(Asset::load(file_));
  const LightId first = scene.lights().front();
  SceneLight light = scene.light(first);
  light.light.position_m = {5, 0, 0};
  scene.set_light(first, light);
  scene.pose(scene.instances().front(), "move", 1);
  EXPECT_EQ(api::placed_scene(scene).lights[0].position_m.x, 5);

  // Of a head that goes, lights stay where they were.
  dermis::Scene other(Asset::load(file_));
  other.pose(other.instances().front(), "move", 1.5);
  other.remove(other.instances().front());
  EXPECT_NEAR(api::placed_scene(other).lights[0].position_m.x, 1.5, 1e-6);
}

TEST_F(Views, OnlyWhatHasNoPoseOfItsOwnPlays) {
  tests::write_text(temp_.path() / "scene.json", R"({"dermis_scene": 1, "assets": [
    {"name": "plays", "file": "carrier.glb"}, {"name": "turns", "file": "carrier.glb", "clip": "turn"},
    {"name": "stands", "file": "carrier.glb", "time_s": 1}], "instances": [
    {"asset": "plays"}, {"asset": "turns"}, {"asset": "stands"},
    {"asset": "plays", "clip": "move", "time_s": 2}]})");
  SceneOptions wanted{.clip = "move", .time_s = 0.5};
  dermis::Scene scene = dermis::Scene::load(temp_.path() / "scene.json", api::at_begin(wanted));
  const std::vector<InstanceId> ids = scene.instances();
  const std::vector<api::Playing> playing = api::playing(scene, wanted);
  ASSERT_EQ(playing.size(), 2u);
  EXPECT_EQ(playing[0].instance, ids[0]);
  EXPECT_EQ(playing[0].clip, "move");
  EXPECT_EQ(playing[1].instance, ids[1]);
  EXPECT_EQ(playing[1].clip, "turn");
  EXPECT_EQ(api::clip_end_s(scene, playing), 2);
  api::play(playing, 0.5, scene);
  EXPECT_EQ(scene.instance(ids[1]).pose->clip->seconds, 0.5);
  EXPECT_EQ(scene.instance(ids[3]).pose->clip->seconds, 2);
  EXPECT_TRUE(api::playing(scene, {}).empty());
  EXPECT_ERROR(tests::thrown<InputError>([&] { api::clip_end_s(scene, {}); }), "nothing that plays a clip");
}

}  // namespace
}  // namespace dermis::scene::test
