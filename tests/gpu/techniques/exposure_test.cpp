// SPDX-License-Identifier: MIT
// An exposure that is chosen: by the light on the skin, the same every time, whatever the skin, the bloom and
// the strength of the lamps.
#include <cmath>

#include "api/exposure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"

namespace dermis::tests {
namespace {

RenderSettings chosen() {
  RenderSettings s = small_settings("texture-space", 64, 128);
  s.output.exposure_ev.reset();
  s.lighting.placed_lights = {{.azimuth_deg = 40, .elevation_deg = 30, .irradiance = 3}};
  s.lighting.rig_lights.reset();
  return s;
}

Scene opened_head() { return subject("built-in head").open(); }

Picture picture_of(const RenderSettings& s) { return renderer().render(opened_head(), s); }

TEST(ChosenExposure, IsTheSameEveryTimeAndGivenAgainTheSamePicture) {
  RenderSettings s = chosen();
  const Picture one = picture_of(s), two = picture_of(s);
  EXPECT_EQ(one.statistics.exposure_ev, two.statistics.exposure_ev);
  expect_equal_bits(one, two);
  ASSERT_TRUE(one.statistics.skin_mean.has_value());

  s.output.exposure_ev = one.statistics.exposure_ev;
  const Picture given = picture_of(s);
  expect_equal_bits(one, given);
  EXPECT_FALSE(given.statistics.skin_mean.has_value());
}

// The stated value: white skin without reflections would show 0.5 on average.
TEST(ChosenExposure, BringsTheLightOnTheSkinToTheStatedValue) {
  RenderSettings s = chosen();
  s.output.exposure_ev = picture_of(s).statistics.exposure_ev;
  s.output.bloom = 0;
  s.lighting.white_albedo = true, s.lighting.specular = false;
  const std::optional<double> mean = api::mean_skin_luminance(picture_of(s).linear_rgba);
  ASSERT_TRUE(mean.has_value());
  EXPECT_NEAR(*mean, api::exposed_light, 0.005);
}

TEST(ChosenExposure, IsOfTheLightAlone) {
  const RenderSettings s = chosen();
  const Statistics st = picture_of(s).statistics;

  RenderSettings other = s;
  other.lighting.white_albedo = true, other.lighting.specular = false;
  const Statistics white = picture_of(other).statistics;
  EXPECT_EQ(white.exposure_ev, st.exposure_ev) << "whatever the skin";
  EXPECT_GT(*white.skin_mean, *st.skin_mean);

  other = s;
  other.output.bloom = 1;
  EXPECT_EQ(picture_of(other).statistics.exposure_ev, st.exposure_ev) << "whatever the bloom";

  // Light beyond what half floats hold is as many stops.
  for (const int stops : {-20, 18}) {
    other = s;
    other.lighting.placed_lights[0].irradiance = std::ldexp(3.0, stops);
    other.lighting.ambient = std::ldexp(s.lighting.ambient, stops);
    const Statistics changed = picture_of(other).statistics;
    EXPECT_NEAR(changed.exposure_ev, st.exposure_ev - stops, 0.011);
    EXPECT_NEAR(*changed.skin_mean / *st.skin_mean, 1, 0.01);
  }
}

TEST(ChosenExposure, WithoutLitSkinIsNone) {
  testing::internal::CaptureStderr();
  RenderSettings s = chosen();
  s.lighting.placed_lights.clear();
  s.lighting.rig_lights = 0, s.lighting.ambient = 0;
  const Statistics dark = picture_of(s).statistics;
  EXPECT_EQ(dark.exposure_ev, 0);
  EXPECT_FALSE(dark.skin_mean.has_value());
  EXPECT_NE(testing::internal::GetCapturedStderr().find(
                "no lit skin in the picture, so an automatic output.exposure_ev is 0"),
            std::string::npos);
}

// A prepared frame that is given an exposure, and none again.
TEST(ChosenExposure, FollowsTheSettingsOfAPreparedFrame) {
  RenderSettings s = chosen();
  PreparedFrame frame = renderer().prepare(opened_head(), s);
  const double ev = frame.picture().statistics.exposure_ev;
  s.output.exposure_ev = 1.5;
  frame.set(s);
  EXPECT_EQ(frame.picture().statistics.exposure_ev, 1.5);
  s.output.exposure_ev.reset();
  s.lighting.placed_lights[0].irradiance *= 4, s.lighting.ambient *= 4;
  frame.set(s);
  EXPECT_NEAR(frame.picture().statistics.exposure_ev, ev - 2, 0.011);
}

}  // namespace
}  // namespace dermis::tests
