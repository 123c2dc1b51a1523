// SPDX-License-Identifier: MIT
// Skin with an alpha test, and skin that emits light: the light map, the shadow map, the picture and the
// reference agree about what is there.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dermis/reference.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "render/techniques/technique.h"

namespace dermis::tests {
namespace {

constexpr double size_m = 0.06;
constexpr float pi = std::numbers::pi_v<float>;

using Alpha = std::function<bool(int x, int y)>;  // of a pixel: is it there?

/// The map of what is there, square; what is not is red, so that any of it that is lit shows. Read as it is,
/// so that edges lie where pixels end.
void cut_out(scene::AssetData& made, int side, const Alpha& is_there) {
  image::Image8 pixels{.width = side, .height = side, .rgba = {}};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const std::uint8_t there = is_there(x, y) ? 255 : 0;
      pixels.rgba.insert(pixels.rgba.end(), {255, there, there, there});
    }
  scene::Material& skin = made.materials.front();
  skin.alpha_mode = AssetAlpha::mask;
  skin.base_colour_map.image = static_cast<int>(made.images.size());
  skin.base_colour_map.nearest = true;
  skin.skin_settings.mix = 1.0f;
  made.images.push_back({.name = "mask", .pixels = std::make_shared<const image::Image8>(std::move(pixels))});
}

/// A plane of which the left half is there, seen from above.
scene::AssetData half_plane(int map_side = 64) {
  scene::AssetData made = scene::plane(size_m, glm::dmat2(1), {}, 4);
  cut_out(made, map_side, [&](int x, int) { return x < map_side / 2; });
  made.cameras.push_back(camera_from_above(size_m / 2, {0, 0, 0.2f}));
  return made;
}

/// A sphere in strips of one pixel, each as wide as the gap beside it: thinner than texels of small maps.
Scene striped_sphere() {
  scene::AssetData made = scene::sphere(0.1);
  cut_out(made, 256, [](int x, int y) { return (x + y) % 2 == 0; });
  return wrap(std::move(made));
}

RenderSettings settings_of(const std::string& technique, bool optimised) {
  RenderSettings s = small_settings(technique);
  s.output.bloom = 0;
  s.quality.cull = s.quality.depth = s.quality.clip = optimised;
  return s;
}

class CutOut : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, CutOut, testing::ValuesIn(technique_names()),
                         [](const auto& technique) { return test_name_of(technique.param); });

// Nothing dark at the rim, nothing red from what is cut away, and no read of light that is not there.
TEST_P(CutOut, WhiteFurnace) {
  for (const bool optimised : {true, false})
    for (const bool strips : {false, true}) {
      SCOPED_TRACE(std::string(strips ? "strips" : "half a plane") + (optimised ? ", optimised" : ""));
      RenderSettings s = settings_of(GetParam(), optimised);
      s.lighting.ambient = 1, s.lighting.rig_lights = 0, s.lighting.specular = false;
      s.quality.map_size = strips ? 96 : 192;
      const Picture picture = renderer().render(strips ? striped_sphere() : wrap(half_plane()), s);
      const SkinRange skin = skin_range(picture);
      EXPECT_GT(skin.pixels, 500u);
      // Blurs of the picture know one value per pixel: of strips as thin as one they lose up to 5.3 %.
      const bool blurred = strips && techniques::find_technique(GetParam()).screen_space;
      EXPECT_GE(skin.low, blurred ? 0.94f : 0.99f);
      EXPECT_LE(skin.high, 1.005f);
      EXPECT_EQ(picture.statistics.unshaded_reads, 0u);
    }
}

// Samples that are shaded together: their middle may lie in a gap that is as thin as a pixel.
TEST(CutOutSamples, ShowsNothingOfTheGaps) {
  for (const std::string technique : {"texture-space", "lambert"}) {
    SCOPED_TRACE(technique);
    RenderSettings s = settings_of(technique, true);
    s.lighting.ambient = 1, s.lighting.rig_lights = 0, s.lighting.specular = false;
    s.quality.map_size = 96;
    const SkinRange skin = skin_range(renderer().render(striped_sphere(), s));
    EXPECT_GE(skin.low, 0.99f);
    EXPECT_LE(skin.high, 1.005f);
  }
}

TEST_P(CutOut, CoversThePixelsThatAreThere) {
  scene::AssetData whole = half_plane();
  whole.materials.front().alpha_mode = AssetAlpha::opaque;
  const RenderSettings s = settings_of(GetParam(), true);
  const double all = static_cast<double>(renderer().render(wrap(whole), s).statistics.skin_pixels);
  EXPECT_EQ(all, 128.0 * 128);
  const Picture half = renderer().render(wrap(half_plane()), s);
  EXPECT_EQ(half.statistics.skin_pixels, 64u * 128);
  for (std::size_t i = 0; i < half.linear_rgba.size(); i += 4) {
    const bool left = i / 4 % 128 < 64;
    ASSERT_EQ(half.linear_rgba[i + 3], left ? 1.0f : 0.0f) << "pixel " << i / 4;
    ASSERT_EQ(half.linear_rgba[i + 1] > 0, left) << "pixel " << i / 4;
  }
}

// Without any light, what a pixel shows is what the skin emits there, to the bit of the half floats.
TEST_P(CutOut, EmissionIsAddedAsItIs) {
  for (const bool mapped : {false, true}) {
    scene::AssetData made = half_plane();
    scene::Material& skin = made.materials.front();
    skin.emissive = {0.25f, 0.5f, 3.0f};
    if (mapped) skin.emissive_map = skin.base_colour_map;  // white where the skin is

    RenderSettings s = settings_of(GetParam(), true);
    s.lighting.rig_lights = 0;
    s.lighting.ambient = 0;
    s.output.exposure_ev = 1;
    const Picture picture = renderer().render(wrap(made), s);

    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x)
        for (int c = 0; c < 3; ++c)
          ASSERT_EQ(picture.linear_rgba[static_cast<std::size_t>(4 * (128 * y + x) + c)],
                    x < 64 ? 2 * skin.emissive[c] : 0.0f)
              << x << " " << y;

    s.output.width = s.output.height = 8;
    const Picture truth = render_reference(wrap(made), s, {.samples = 2}).picture;
    for (int i = 0; i < 64; ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(truth.linear_rgba[static_cast<std::size_t>(4 * i + c)],
                    i % 8 < 4 ? 2 * skin.emissive[c] : 0.0f, 1e-5f);
  }
}

// Emission is not scattered and does not change what is: it is on top.
TEST_P(CutOut, EmissionIsOnTopOfTheLight) {
  scene::AssetData made = scene::sphere(0.1);
  RenderSettings s = settings_of(GetParam(), true);
  const SkinRange lit = skin_range(renderer().render(wrap(made), s));
  made.materials.front().emissive = glm::vec3(0.5f);
  const SkinRange both = skin_range(renderer().render(wrap(made), s));
  ASSERT_EQ(lit.pixels, both.pixels);
  // The picture is in half floats: between 1 and 2 they are 2^-10 apart.
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(both.mean[c] - lit.mean[c], 0.5, 2 * half_rounding);
}

TEST_P(CutOut, ValidationIsSilent) {
  if (!is_validated()) GTEST_SKIP() << "the validation layers are not installed";
  scene::AssetData made = half_plane(61);
  made.materials.front().emissive = glm::vec3(1);
  RenderSettings s = settings_of(GetParam(), true);
  s.output.width = s.output.height = 32, s.quality.map_size = 64;
  if (techniques::find_technique(GetParam()).has_light_maps) s.output.show = "visibility";
  renderer().render(wrap(made), s);
}

double lit_share(const Picture& picture, int from_column, int to_column, std::size_t channel) {
  double lit = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = from_column; x < to_column; ++x)
      lit += picture.linear_rgba[4 * static_cast<std::size_t>(y * picture.width + x) + channel] > 0;
  return lit / (picture.height * (to_column - from_column));
}

TEST(CutOutMaps, ShadowEndsAtTheCut) {
  scene::AssetData made = half_plane(256);
  made.lights.push_back({.name = "sun", .colour = glm::vec3(pi)});
  RenderSettings s = settings_of("texture-space", false);
  s.output.show = "shadow:0";
  const double half = lit_share(renderer().render(wrap(made), s), 0, 256, 0);
  made.materials.front().alpha_mode = AssetAlpha::opaque;
  const double all = lit_share(renderer().render(wrap(made), s), 0, 256, 0);
  // The cut may lie off by one of the hundred and more columns that the plane takes in the shadow map.
  EXPECT_NEAR(half / all, 0.5, 0.01);
}

// Light does not spread from what is cut away: the edge of a lit region is as sharp as the skin beside it
// makes it, whether skin or nothing lies beyond the cut.
TEST(CutOutMaps, WhatIsCutAwayIsNotBlurred) {
  scene::AssetData made = half_plane();
  scene::AssetData narrow = scene::plane(size_m, glm::dmat2(1), {}, 4);
  narrow.cameras = made.cameras;
  for (scene::Vertex& v : narrow.primitives.front().vertices) {
    v.position_m.x = v.position_m.x / 2 - static_cast<float>(size_m) / 4;
    v.uv0.x /= 2;
  }

  for (scene::AssetData* scene : {&made, &narrow})
    scene->lights.push_back(
        {.name = "lamp", .type = LightType::point, .colour = glm::vec3(0.001f), .position_m = {0, 0, 0.02f}});

  RenderSettings s = settings_of("texture-space", true);
  s.lighting.ambient = 0;
  s.lighting.specular = false;
  s.skin.translucency = false;
  const Picture cut = renderer().render(wrap(made), s), ends = renderer().render(wrap(narrow), s);

  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto i = static_cast<std::size_t>(4 * (128 * y + x));
      // Twenty roundings of half floats.
      ASSERT_NEAR(cut.linear_rgba[i + 1], ends.linear_rgba[i + 1], 0.01 * ends.linear_rgba[i + 1] + 1e-4)
          << x << " " << y;
    }
}

// A lamp over a plane of skin with a hole; under it a second one, that the light through the hole falls on.
// A profile so narrow that it does not matter what either does at open borders.
TEST(CutOutMaps, IsThatOfTheReference) {
  scene::AssetData made = scene::plane(size_m, glm::dmat2(1), {}, 1);
  scene::AssetData sheet = scene::plane(size_m, glm::dmat2(1), {}, 1);
  sheet.materials.front().name = "skin with a hole";
  cut_out(sheet, 8, [](int x, int y) { return x < 2 || x > 5 || y < 2 || y > 5; });
  sheet.materials.front().base_colour_map.image = 0;

  ScatterProfile narrow;
  narrow.name = "narrow";
  narrow.terms = {{.variance_mm2 = 1e-3, .weight = {1, 1, 1}}};
  made.materials.front().skin_settings.profile = sheet.materials.front().skin_settings.profile = narrow;
  made.images = sheet.images;
  made.materials.push_back(sheet.materials.front());
  made.primitives.push_back(sheet.primitives.front());
  made.primitives.back().material = 1;
  made.primitives.back().node = 1;
  for (scene::Vertex& v : made.primitives.back().vertices) v.position_m.z += 0.02f;
  made.lights.push_back({.name = "sun", .colour = glm::vec3(pi)});
  made.cameras.push_back(camera_from_above(size_m / 2, {0, 0, 0.2f}));

  RenderSettings s = settings_of("texture-space", true);
  s.output.width = s.output.height = 64;
  s.quality.map_size = 512;
  s.quality.shadow_size = 1024;
  s.lighting.ambient = 0;
  s.lighting.specular = false;
  s.skin.translucency = false;
  const Picture picture = renderer().render(wrap(made), s),
                truth = render_reference(wrap(made), s, {.samples = 64}).picture;

  double difference = 0, all = 0;
  for (int y = 10; y < 54; ++y)
    for (int x = 10; x < 54; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto i = static_cast<std::size_t>(4 * (64 * y + x)) + c;
        difference += picture.linear_rgba[i] - truth.linear_rgba[i];
        all += truth.linear_rgba[i];
      }

  std::printf("mean difference %.4f of the mean\n", difference / all);
  EXPECT_GT(all, 100);
  // The light through the hole ends at a rim 128 pixels long, which may lie off by half a pixel of 44 x 44:
  // a texel of the shadow map and one of the light map.
  EXPECT_NEAR(difference / all, 0, 0.03);
}

}  // namespace
}  // namespace dermis::tests
