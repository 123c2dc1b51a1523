// SPDX-License-Identifier: MIT
// The manifest of the scan, as the loader understands it: size, orientation, flipped coordinates, skin,
// camera and lights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "head/scene/asset_data.h"
#include "head/scene/gltf/load.h"
#include "support/assets.h"

namespace dermis::scene {
namespace {

class Scan : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string missing = tests::missing_scan({"Map-SPEC.jpg", "Infinite-Level_02_Tangent_SmoothUV.jpg",
                                                     "Infinite-Level_02_Disp_NoSmoothUV-4096.jpg"});
    if (!missing.empty()) GTEST_SKIP() << missing;
    static const AssetData loaded = load_gltf(tests::scan_manifest());
    scene_ = &loaded;
    ASSERT_EQ(scene_->primitives.size(), 1u);
    ASSERT_EQ(scene_->materials.size(), 1u);
  }
  const Primitive& head() const { return scene_->primitives[0]; }
  const Material& skin() const { return scene_->materials[0]; }
  const Vertex& nose_tip() const {
    const auto& v = head().vertices;
    return *std::max_element(
        v.begin(), v.end(), [](const Vertex& a, const Vertex& b) { return a.position_m.z < b.position_m.z; });
  }

  const AssetData* scene_ = nullptr;
};

TEST_F(Scan, IsAHeadInMetres) {
  EXPECT_EQ(head().indices.size() / 3, 17684u);
  float low = 1, high = -1;
  for (const Vertex& v : head().vertices) {
    low = std::min(low, v.position_m.y);
    high = std::max(high, v.position_m.y);
  }
  EXPECT_NEAR(high - low, 0.4211, 0.0005);  // the original's height
}

TEST_F(Scan, FacesTheViewer) {
  // The nose is the foremost point and points along +Z.
  EXPECT_NEAR(nose_tip().position_m.z, 0.1373, 0.0005);
  EXPECT_GT(nose_tip().normal.z, 0.98f);
}

TEST_F(Scan, ReadsItsMapsTheRightWayUp) {
  const SkinMaterial& settings = skin().skin_settings;
  for (const MapRef* map :
       {&skin().base_colour_map, &skin().normal_map, &settings.specular, &settings.displacement}) {
    ASSERT_TRUE(map->present());
    // In the pictures the nose tip is at 0.387 of the height from the top; the file's coordinates count from
    // the bottom.
    const glm::vec2 uv = map->transform * glm::vec3(nose_tip().uv0, 1.f);
    EXPECT_NEAR(uv.x, 0.500f, 0.001f);
    EXPECT_NEAR(uv.y, 0.387f, 0.001f);
  }
  const auto side = [&](const MapRef& map) {
    return scene_->images[static_cast<std::size_t>(map.image)].pixels->width;
  };
  EXPECT_EQ(side(skin().normal_map), 1024);
  EXPECT_EQ(side(settings.displacement), 4096);
}

TEST_F(Scan, IsSkin) {
  EXPECT_TRUE(skin().skin);
  ASSERT_TRUE(skin().skin_settings.mix.has_value());
  EXPECT_EQ(*skin().skin_settings.mix, 0.f);  // photographed colour: all of it acts after scattering
  EXPECT_EQ(skin().skin_settings.specular.channel, 0);
  EXPECT_NEAR(skin().skin_settings.displacement_mm, 3.f, 1e-6f);
  EXPECT_NEAR(skin().skin_settings.displacement_middle, 137 / 255., 0.001);
  EXPECT_NEAR(skin().ior, 1.4f, 1e-6f);
}

TEST_F(Scan, PortraitCameraHoldsTheHead) {
  ASSERT_EQ(scene_->cameras.size(), 1u);
  const Camera& camera = scene_->cameras[0];
  EXPECT_EQ(camera.name, "portrait");
  const glm::mat4 camera_from_world = glm::inverse(camera.world_from_camera);
  const float tan_y = std::tan(camera.fov_y_rad / 2), tan_x = tan_y * 960 / 1080;
  float highest = -1;
  for (const Vertex& v : head().vertices) {
    if (v.position_m.y < -0.05f) continue;  // neck and shoulders may leave the picture
    const glm::vec4 p = camera_from_world * glm::vec4(v.position_m, 1);
    ASSERT_LT(p.z, -0.3f);
    EXPECT_LT(std::abs(p.x / -p.z), 0.95f * tan_x);
    EXPECT_LT(std::abs(p.y / -p.z), 0.95f * tan_y);
    highest = std::max(highest, p.y / -p.z / tan_y);
  }
  EXPECT_GT(highest, 0.75f);  // and fills it
}

TEST_F(Scan, LightsComeFromBothSides) {
  ASSERT_EQ(scene_->lights.size(), 2u);
  ASSERT_EQ(scene_->cameras.size(), 1u);
  const glm::mat3 camera_from_world = glm::transpose(glm::mat3(scene_->cameras[0].world_from_camera));
  const glm::vec3 to_key = -(camera_from_world * scene_->lights[0].direction),
                  to_fill = -(camera_from_world * scene_->lights[1].direction);
  EXPECT_EQ(scene_->lights[0].type, LightType::directional);
  EXPECT_EQ(scene_->lights[1].type, LightType::directional);
  EXPECT_LT(to_key.x, -0.5f);  // upper left, before the face
  EXPECT_GT(to_key.y, 0.3f);
  EXPECT_GT(to_key.z, 0.3f);
  EXPECT_GT(to_fill.x, 0.7f);
  // irradiance: a face-on white surface would show as 3/pi
  EXPECT_NEAR(scene_->lights[0].colour.r, 3.f, 1e-4f);
  EXPECT_NEAR(scene_->lights[1].colour.b, 0.8f, 1e-4f);
}

}  // namespace
}  // namespace dermis::scene
