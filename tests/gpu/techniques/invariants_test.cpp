// SPDX-License-Identifier: MIT
// What must hold for every technique of the list, whatever it does inside. A new technique is tested by being
// in the list.
#include <algorithm>
#include <cmath>

#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"

namespace dermis::tests {
namespace {

constexpr double head_radius_m = 0.1;

std::string test_name(const testing::TestParamInfo<std::string>& info) { return test_name_of(info.param); }

class EveryTechnique : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, EveryTechnique, testing::ValuesIn(technique_names()), test_name);

TEST_P(EveryTechnique, NoLightIsBlack) {
  RenderSettings s = small_settings(GetParam());
  s.lighting.rig_lights = 0;
  s.lighting.ambient = 0;
  const Picture picture = renderer().render(sphere(head_radius_m), s);
  ASSERT_EQ(picture.linear_rgba.size(), 4u * 128 * 128);
  EXPECT_GT(skin_range(picture).pixels, 5000u);
  for (std::size_t i = 0; i < picture.linear_rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    ASSERT_EQ(picture.linear_rgba[i], 0.0f) << "value " << i;
  }
}

// Head by head, every technique on each: what is uploaded of a head serves all its pictures.
class EveryHead : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!subject(GetParam()).missing.empty()) GTEST_SKIP() << subject(GetParam()).missing;
  }
};
INSTANTIATE_TEST_SUITE_P(Heads, EveryHead, testing::ValuesIn(subject_names()), test_name);

// Under white light from everywhere white skin is white, seams included, whatever is blurred where.
TEST_P(EveryHead, IsWhiteInAWhiteFurnace) {
  for (const std::string& technique : technique_names())
    for (const bool specular : {false, true}) {
      SCOPED_TRACE(technique + (specular ? " with specular" : ""));
      // Light is stored about ten times on its way, in half floats. What skin reflects does not enter it:
      // that share, about a half where light grazes, is known from a fit that is good to 2 %
      // (DirectionalAlbedo.MatchesFineQuadrature).
      const double tolerance = specular ? 0.01 : 10 * half_rounding;
      const SkinRange skin =
          skin_range(renderer().render(subject(GetParam()).open(), furnace_settings(technique, specular)));
      EXPECT_GT(skin.pixels, 1000u);
      EXPECT_GE(skin.low, 1 - tolerance);
      EXPECT_LE(skin.high, 1 + tolerance);
    }
}

void expect_equal_runs(const Picture& a, const Picture& b) {
  expect_equal_bits(a, b);
  EXPECT_EQ(a.statistics.irradiance_texels, b.statistics.irradiance_texels);
  EXPECT_EQ(a.statistics.skin_pixels, b.statistics.skin_pixels);
}

TEST_P(EveryTechnique, TwoRunsAreBitEqual) {
  const RenderSettings s = small_settings(GetParam());
  const Scene head = subject("built-in head").open();
  const Picture first = renderer().render(head, s);
  EXPECT_GT(skin_range(first).mean[0], 0.01);
  {
    SCOPED_TRACE("the same renderer");
    expect_equal_runs(first, renderer().render(head, s));
  }
  SCOPED_TRACE("another renderer");
  Renderer other;
  expect_equal_runs(first, other.render(head, s));
}

// The number of timed frames must not show in the picture: nothing is carried from frame to frame.
TEST_P(EveryTechnique, ThePictureDoesNotDependOnTheNumberOfFrames) {
  RenderSettings s = small_settings(GetParam());
  const Scene head = sphere(head_radius_m);
  const Picture first = renderer().render(head, s);
  s.output.frames = 3;
  expect_equal_runs(first, renderer().render(head, s));
}

TEST_P(EveryTechnique, HalvingTheMapKeepsTheMeanColour) {
  RenderSettings s = small_settings(GetParam());
  s.output.bloom = 0;
  for (const char* name : {"sphere", "built-in head"}) {
    SCOPED_TRACE(name);
    const Scene head = subject(name).open();
    s.quality.map_size = 512;
    const SkinRange fine = skin_range(renderer().render(head, s));
    s.quality.map_size = 256;
    const SkinRange coarse = skin_range(renderer().render(head, s));
    EXPECT_EQ(fine.pixels, coarse.pixels);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GT(fine.mean[c], 0.01);
      // Resolution: a texel holds the light of its middle, twice as large ones miss more of how it bends.
      EXPECT_NEAR(coarse.mean[c] / fine.mean[c], 1, 0.01) << "channel " << c;
    }
  }
}

// Scattering moves light, it neither makes nor loses any. Lit from the camera, little of it leaves for the
// far side.
TEST_P(EveryTechnique, ScatteringKeepsTheLight) {
  const auto render = [](const std::string& technique) {
    RenderSettings s = small_settings(technique);
    s.lighting.ambient = 0;
    s.output.bloom = 0;
    return sum(renderer().render(sphere_lit_from_the_camera(head_radius_m), s));
  };
  const std::array<double, 3> without = render("lambert"), with = render(GetParam());
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_GT(without[c], 1000);
    EXPECT_NEAR(with[c] / without[c], 1, 0.02) << "channel " << c;
  }
}

TEST_P(EveryTechnique, ValidationIsSilent) {
  if (!is_validated()) GTEST_SKIP() << "the validation layers are not installed";
  RenderSettings s = small_settings(GetParam());
  s.camera.heads = 2;
  renderer().render(subject("built-in head").open(), s);
  if (const Subject& other = subject("MakeHuman"); other.missing.empty())
    renderer().render(other.open(), small_settings(GetParam()));
}

}  // namespace
}  // namespace dermis::tests
