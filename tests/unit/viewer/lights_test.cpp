// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "unit/viewer/documents.h"
#include "viewer/model/light_places.h"

namespace dermis::viewer {
namespace {

const HeadSphere sphere{.centre_m = {0.1, 1.5, -0.2}, .radius_m = 0.2};

TEST(LightPlaces, ALightIsFoundWhereItWasPlaced) {
  for (const LightType type : {LightType::spot, LightType::point, LightType::directional}) {
    Light light;
    light.type = type;
    light.colour = {2, 1, 0.5};
    light.position_m = {0.1, 1.5, 1.8};  // two metres before the centre
    light.direction = {0, 0, -1};
    for (const PlacedLight at :
         {PlacedLight{30, 20, 3}, PlacedLight{-150, -60, 0.25}, PlacedLight{89, 0, 10}}) {
      const Light moved = placed(light, at, sphere);
      const PlacedLight found = place_of(moved, sphere);
      EXPECT_NEAR(found.azimuth_deg, at.azimuth_deg, 1e-9);
      EXPECT_NEAR(found.elevation_deg, at.elevation_deg, 1e-9);
      EXPECT_NEAR(found.irradiance, at.irradiance, 1e-9);
      // Its hue stays, and its distance.
      EXPECT_NEAR(moved.colour[1] / moved.colour[0], 0.5, 1e-12);
      if (type != LightType::directional) { EXPECT_NEAR(moved.colour[0], at.irradiance * 4, 1e-9); }
    }
  }
}

TEST(LightPlaces, AToneChangesTheHueAlone) {
  Light light;
  light.colour = {8, 4, 2};
  const Light blue = with_tone(light, {0.25, 0.25, 0.5});
  EXPECT_NEAR(blue.colour[2], 8, 1e-12);
  EXPECT_NEAR(blue.colour[0], 4, 1e-12);
  light.colour = {0, 0, 0};
  EXPECT_EQ(tone_of(light), (std::array<double, 3>{1, 1, 1}));
}

TEST(LightPlaces, OwnLightsAreThoseThatTheSettingsPlaced) {
  Document document = tests::square_document();
  EXPECT_FALSE(draws_scene_lights(document));
  document.settings.lighting.placed_lights = {{.azimuth_deg = 70, .elevation_deg = -10, .irradiance = 2},
                                              {.azimuth_deg = -20, .elevation_deg = 40, .irradiance = 5}};
  own_lights(document);
  EXPECT_TRUE(draws_scene_lights(document));
  ASSERT_EQ(document.scene.lights().size(), 2u);
  const HeadSphere head = head_sphere(document);
  const PlacedLight second = place_of(document.scene.light(document.scene.lights()[1]).light, head);
  EXPECT_NEAR(second.azimuth_deg, -20, 1e-4);
  EXPECT_NEAR(second.elevation_deg, 40, 1e-4);
  EXPECT_NEAR(second.irradiance, 5, 1e-4);
}

TEST(LightPlaces, TheRigComesBackOnlyIfAsked) {
  Document document = tests::square_document();
  own_lights(document);
  EXPECT_EQ(document.scene.lights().size(), 2u);  // key and fill

  document.settings.lighting.rig_lights = 0;
  own_lights(document);
  EXPECT_TRUE(document.scene.lights().empty());
  EXPECT_EQ(document.settings.lighting.rig_lights, 0);

  const LightId lamp = add_lamp(document, {.azimuth_deg = 10, .elevation_deg = 5, .irradiance = 3});
  EXPECT_EQ(document.scene.lights(), std::vector{lamp});
  EXPECT_TRUE(draws_scene_lights(document));
  EXPECT_NEAR(place_of(document.scene.light(lamp).light, head_sphere(document)).azimuth_deg, 10, 1e-4);
}

TEST(LightPlaces, ALightOfARigStandsInItsInstance) {
  Document document = tests::square_document();
  const InstanceId head = document.scene.instances().front();
  // Twice as large, three metres to the side.
  document.scene.set_transform(head, {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 3, 0, 0, 1});
  const HeadSphere of_rig =
      in_rig(head_sphere(document), document.scene, SceneLight{.light = {}, .rig = head});
  EXPECT_NEAR(of_rig.centre_m[0], 0, 1e-6);
  EXPECT_NEAR(of_rig.centre_m[1], 0.5, 1e-6);
  EXPECT_NEAR(of_rig.radius_m * 2, head_sphere(document).radius_m, 1e-6);
}

}  // namespace
}  // namespace dermis::viewer
