// SPDX-License-Identifier: MIT
// Lights and cameras, on files built in memory.
#include <cmath>
#include <numbers>

#include "support.h"

namespace dermis::scene::test {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

}  // namespace

TEST(GltfViews, LightsOfEachKind) {
  Builder b;
  b.triangle();
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([
    {"type": "directional", "intensity": 3, "color": [1, 0.5, 0]},
    {"type": "point", "intensity": 2, "range": 10, "name": "lamp"},
    {"type": "spot", "intensity": 1, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}])");

  for (int i = 0; i < 3; ++i) {
    b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}},
                               {"translation", {0, 0, 4}},
                               {"name", "node"},
                               {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}},
                               {"scale", {3, 3, 3}}});
    b.json["scenes"][0]["nodes"].push_back(i + 1);
  }

  LoadOptions options;
  options.unit_scale = 0.5;
  const std::vector<Light> lights = b.load(options).lights;
  ASSERT_EQ(lights.size(), 3u);

  EXPECT_EQ(lights[0].type, LightType::directional);
  EXPECT_EQ(lights[0].colour, glm::vec3(3, 1.5f, 0));
  EXPECT_EQ(lights[0].name, "node");
  expect_near(lights[0].direction, {-1, 0, 0});  // -z turned by 90 degrees about y

  EXPECT_EQ(lights[1].name, "lamp");
  expect_near(lights[1].position_m, {0, 0, 2});
  EXPECT_EQ(lights[1].range_m, 5);
  EXPECT_EQ(lights[1].colour.x, 0.5f);  // half the distance, a quarter of the intensity: as bright as before
  EXPECT_EQ(lights[2].outer_cone_rad, 0.2f);
  for (const Light& light : lights) EXPECT_EQ(light.radius, 0);
}

TEST(GltfViews, LightsWithARadius) {
  const auto load = [](const std::string& light) {
    Builder b;
    b.triangle();
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse("[" + light + "]");
    b.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    b.json["scenes"][0]["nodes"].push_back(1);
    LoadOptions options;
    options.unit_scale = 0.5;
    return b.load(options).lights.at(0).radius;
  };

  EXPECT_FLOAT_EQ(load(R"({"type": "point", "extras": {"dermis": {"radius_m": 0.3}}})"), 0.15f);
  // tangent of half of it
  EXPECT_FLOAT_EQ(load(R"({"type": "directional", "extras": {"dermis": {"angle_deg": 90}}})"), 1);
  EXPECT_EQ(load(R"({"type": "point", "extras": {"other": {"radius_m": 0.3}}})"), 0);
  EXPECT_EQ(load(R"({"type": "point", "extras": 7})"), 0);

  for (const char* wrong : {R"({"type": "point", "extras": {"dermis": {"radius_m": -1}}})",
                            R"({"type": "point", "extras": {"dermis": {"radius_m": "big"}}})",
                            R"({"type": "point", "extras": {"dermis": {"angle_deg": 1}}})",
                            R"({"type": "point", "extras": {"dermis": 3}})",
                            R"({"type": "directional", "extras": {"dermis": {"angle_deg": 180}}})",
                            R"({"type": "directional", "extras": {"dermis": {"radius_m": 1}}})"})
    EXPECT_THROW(load(wrong), InputError) << wrong;
}

TEST(GltfViews, CamerasOfBothKinds) {
  Builder b;
  b.triangle();
  b.json["cameras"] =
      Json::parse(R"([{"type": "perspective", "name": "portrait", "perspective": {"yfov": 0.5, "znear": 0.2}},
    {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 2, "znear": 0.1, "zfar": 10}}])");

  for (int i = 0; i < 2; ++i) {
    b.json["nodes"].push_back(
        {{"camera", i}, {"translation", {0, 0, 4}}, {"scale", {2, 2, -2}}, {"name", "eye"}});
    b.json["scenes"][0]["nodes"].push_back(i + 1);
  }

  LoadOptions options;
  options.unit_scale = 0.5;
  const std::vector<Camera> cameras = b.load(options).cameras;
  ASSERT_EQ(cameras.size(), 2u);

  EXPECT_EQ(cameras[0].name, "portrait");
  EXPECT_EQ(cameras[0].fov_y_rad, 0.5f);
  EXPECT_EQ(cameras[0].znear_m, 0.1f);
  EXPECT_FALSE(cameras[0].zfar_m);
  EXPECT_EQ(cameras[1].name, "eye");
  EXPECT_TRUE(cameras[1].orthographic);
  EXPECT_EQ(cameras[1].ymag_m, 1);
  EXPECT_EQ(cameras[1].zfar_m, 5.0f);
  expect_near(glm::vec3(cameras[0].world_from_camera[3]), {0, 0, 2});
  // mirrored: still rigid, still looking along its -z
  expect_near(glm::vec3(cameras[0].world_from_camera[2]), {0, 0, -1});
  EXPECT_NEAR(glm::determinant(glm::mat3(cameras[0].world_from_camera)), 1, 1e-6f);

  b.json["cameras"][0]["perspective"]["yfov"] = pi;
  const Warnings warnings;
  const AssetData scene = b.load();
  ASSERT_EQ(scene.cameras.size(), 1u) << "the other is left out";
  EXPECT_EQ(scene.cameras[0].name, "eye");
  EXPECT_TRUE(warnings.any_with("yfov must be less than pi"));
}
}  // namespace dermis::scene::test
