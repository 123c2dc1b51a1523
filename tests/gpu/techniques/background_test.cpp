// SPDX-License-Identifier: MIT
// What stands behind the heads: where no surface covers a pixel, by the share that none covers, and nowhere
// else.
#include <cmath>
#include <numbers>
#include <set>

#include "base/settings/names.h"
#include "environment/environment.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "image/codec.h"
#include "image/colour.h"
#include "support/files.h"

namespace dermis::tests {
namespace {

constexpr std::array<int, 3> blue{0x33, 0x66, 0xc9};

RenderSettings before(const std::string& background, RenderSettings s = small_settings("lambert")) {
  s.output.background = background;
  return s;
}

Picture drawn(const Scene& scene, RenderSettings settings) { return renderer().render(scene, settings); }

// A half transparent ball, of one layer of triangles, around a small one of skin.
Scene glass() {
  scene::AssetData balls = scene::sphere(0.1, 16);
  const scene::AssetData inner = scene::sphere(0.03, 16);
  balls.materials.push_back(inner.materials[0]);
  balls.primitives.push_back(inner.primitives[0]);
  balls.primitives[1].material = 1;
  balls.materials[0].skin = false;
  balls.materials[0].base_colour = {0.8f, 0.4f, 0.2f, 0.5f};
  balls.materials[0].alpha_mode = AssetAlpha::blend;
  return wrap(std::move(balls));
}

// The published technique draws skin where its triangles are, others shade it first.
class Background : public testing::TestWithParam<std::string> {
 protected:
  static RenderSettings settings() { return small_settings(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Drawn, Background, testing::Values("texture-space", "published"),
                         [](const auto& technique) { return test_name_of(technique.param); });

// Of display values, too, whatever becomes of the light.
TEST_P(Background, AColourIsShownAsItWasGiven) {
  const Scene head = sphere(0.1);
  RenderSettings s = settings();
  s.output.bloom = 0;
  const Picture black = drawn(head, s);
  s.output.bloom = 0.3;
  s.output.exposure_ev = 2;
  for (const std::string_view name : names_of<ToneMap>) {
    s.output.tone_map = find_name<ToneMap>("tone map", name);
    const Picture found = drawn(head, before("#3366c9", s));
    std::size_t behind = 0, different = 0;
    for (std::size_t i = 0; i < found.display_rgba.size(); i += 4) {
      const float* const light = &black.linear_rgba[i];
      if (light[0] + light[1] + light[2] + light[3] > 0) continue;
      ++behind;
      for (std::size_t c = 0; c < 3; ++c) different += found.display_rgba[i + c] != blue[c];
    }
    EXPECT_GT(behind, 4000u);
    EXPECT_EQ(different, 0u) << name;
  }
}

// The share is a number of samples; where it is 0 nothing changes, and nowhere does alpha, the share of skin.
TEST_P(Background, ItIsAddedByTheShareThatNothingCovers) {
  const Scene head = sphere(0.1);
  RenderSettings s = settings();
  s.output.bloom = 0;
  const Picture black = drawn(head, s), white = drawn(head, before("#ffffff", s));
  std::set<float> shares;
  for (std::size_t i = 0; i < black.linear_rgba.size(); i += 4) {
    const float alpha = black.linear_rgba[i + 3];
    ASSERT_EQ(white.linear_rgba[i + 3], alpha);
    shares.insert(alpha);
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(white.linear_rgba[i + c], black.linear_rgba[i + c] + (1 - alpha), half_rounding);
  }
  EXPECT_EQ(shares, (std::set<float>{0, 0.25f, 0.5f, 0.75f, 1}));
}

TEST_P(Background, ItShowsThroughWhatIsBlended) {
  for (const int samples : {1, 4}) {
    RenderSettings s = settings();
    s.quality.samples = samples;
    s.camera.eye_m = {0, 0, 0.6};
    s.camera.target_m = {0, 0, 0};
    s.camera.fov_deg = 30;
    s.output.bloom = 0;
    const Picture black = drawn(glass(), s), white = drawn(glass(), before("#ffffff", s));
    const auto added = [&](int x) {
      const auto i = 4 * static_cast<std::size_t>(black.width * (black.height / 2) + x);
      return white.linear_rgba[i] - black.linear_rgba[i];
    };
    EXPECT_EQ(added(64), 0) << "skin";
    EXPECT_NEAR(added(34), 0.5, 2 * half_rounding) << "glass";
    EXPECT_NEAR(white.linear_rgba[0], 1, half_rounding);
  }
}

TEST(Backgrounds, TheStudioFallsOffByTheFourthPowerOfTheCosine) {
  const Scene head = sphere(0.1);
  RenderSettings s = before("studio");
  s.output.width = 192;
  s.output.bloom = 0;
  s.output.exposure_ev = 1;
  const Picture found = drawn(head, s);
  for (const auto& [x, y] : {std::pair{0, 0}, {191, 127}, {191, 5}, {3, 64}}) {
    const double right = (x + 0.5 - 96) / 128, down = (y + 0.5 - 64) / 128;
    const double wanted = 2 * 0.18 / std::pow(1 + right * right + down * down, 2);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(found.linear_rgba[4 * static_cast<std::size_t>(y * 192 + x) + c], wanted,
                  half_rounding * wanted);
  }
}

// Each pixel by the ray through it; the surroundings are turned and brightened.
TEST(Backgrounds, SurroundingsAreSeenWhereTheyAre) {
  const std::string path = (program_folder() / "colourful.exr").string();
  image::ImageF around{.width = 32, .height = 16, .channels = 3, .values = {}};
  for (int i = 0; i < 32 * 16 * 3; ++i)
    around.values.push_back(static_cast<float>(0.3 + 0.2 * std::sin(1.7 * i) * std::cos(0.31 * i)));
  image::save_exr(path, around);

  RenderSettings s = before("environment");
  s.camera.eye_m = {0.5, 0.3, 0.9};
  s.camera.target_m = {0, 0, 0};
  s.camera.fov_deg = 60;
  s.lighting.rig_lights = 0;
  s.lighting.environment = path;
  s.lighting.environment_intensity = 2;
  s.lighting.environment_rotation_deg = 130;
  s.output.bloom = 0;
  const Picture found = drawn(sphere(0.05), s);

  const glm::dvec3 forward = -glm::normalize(glm::dvec3(0.5, 0.3, 0.9)),
                   right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))),
                   up = glm::cross(right, forward);
  const double tangent = std::tan(std::numbers::pi / 6), angle = 130 * std::numbers::pi / 180;
  for (const auto& [x, y] : {std::pair{2, 3}, {120, 10}, {64, 4}, {5, 100}, {126, 125}, {20, 64}}) {
    const glm::dvec3 d = glm::normalize(forward + tangent * ((x - 63.5) / 64 * right - (y - 63.5) / 64 * up));
    // From the head's front (+Z) towards its left (+X), and back.
    const glm::dvec3 turned(d.x * std::cos(angle) - d.z * std::sin(angle), d.y,
                            d.x * std::sin(angle) + d.z * std::cos(angle));
    const glm::dvec3 wanted = 2.0 * environment::radiance_at(around, environment::place_of(turned));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found.linear_rgba[4 * static_cast<std::size_t>(y * 128 + x) + static_cast<std::size_t>(c)],
                  wanted[c], 0.005)
          << x << ", " << y;
  }
}

// Without a picture of them, the uniform light that there is instead.
TEST(Backgrounds, UniformSurroundingsAreTheAmbientLight) {
  RenderSettings s = before("environment");
  s.lighting.ambient = 0.25;
  s.output.bloom = 0;
  const Picture found = drawn(sphere(0.05), s);
  EXPECT_NEAR(found.linear_rgba[0], 0.25, half_rounding);
}

// Bloom takes in what is light behind the heads, and exposure sets it.
TEST(Backgrounds, LightBehindTheHeadsBlooms) {
  RenderSettings s = before("environment");
  s.lighting.rig_lights = 0;
  s.lighting.ambient = 1;
  s.lighting.white_albedo = true;
  s.lighting.specular = false;
  s.output.bloom = 0.3;
  const Picture furnace = drawn(sphere(0.05), s);
  for (std::size_t i = 0; i < furnace.linear_rgba.size(); i += 4)
    ASSERT_NEAR(furnace.linear_rgba[i], 1, 0.005) << "white in white surroundings is not seen";
}

}  // namespace
}  // namespace dermis::tests
