// SPDX-License-Identifier: MIT
// Skin is shaded once per entry of a pixel: its pictures are the super-sampled ones, made smaller.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <utility>

#include "gpu/support/failure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/builtin_head/builtin_head.h"
#include "head/scene/import/shapes.h"
#include "image/metrics.h"
#include "render/shared/entries_io.h"

namespace dermis::tests {
namespace {

RenderSettings settings_at(double distance, const std::string& technique = "texture-space") {
  RenderSettings s = small_settings(technique, 160, 256);
  s.camera.distance = distance;
  s.output.bloom = 0;
  s.output.tone_map = ToneMap::filmic;
  return s;
}

// The same from more pixels each way, of which no side is left out.
image::ImageF truth_of(const Scene& scene, const RenderSettings& s, int times = 4) {
  RenderSettings truth = super_sampled(s, times);
  truth.quality.samples = times >= 8 ? 1 : 4;
  truth.quality.cull = truth.quality.clip = false;
  return downsampled(renderer().render(scene, truth), times);
}

// The sum of all pixels, of red, green and blue.
double light_of(const image::ImageF& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    if (i % 4 != 3) sum += picture.values[i];
  return sum;
}

// Compares displayed skin, and the share of each pixel that is skin. `blended`: blended parts lie over some.
void expect_true(const Scene& scene, const RenderSettings& s, double least_db, bool blended = false) {
  const Picture picture = renderer().render(scene, s);
  const image::ImageF wanted = truth_of(scene, s), found = linear(picture);
  const double db = image::psnr_db(shown(wanted), shown(picture), skin_mask(picture));
  std::printf("%.1f dB\n", db);
  EXPECT_GE(db, least_db) << write_failure(wanted, found);
  EXPECT_EQ(picture.statistics.unshaded_reads, 0u);
  if (blended) return;
  double share = 0, wanted_share = 0, most = 0;
  for (std::size_t i = 3; i < found.values.size(); i += 4) {
    share += double{found.values[i]}, wanted_share += double{wanted.values[i]};
    most = std::max(most, std::abs(double{found.values[i]} - double{wanted.values[i]}));
  }
  EXPECT_NEAR(share / wanted_share, 1, 0.01);
  EXPECT_LE(most, s.quality.samples == 1 ? 1 : 0.6) << "share of skin of a pixel";
}

class Shading : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, Shading, testing::ValuesIn(other_than_published()),
                         [](const auto& technique) { return test_name_of(technique.param); });

TEST_P(Shading, OfANearHead) {
  for (const std::string name : {"built-in head", "scan", "MakeHuman", "ICT"}) {
    if (!subject(name).missing.empty()) continue;
    SCOPED_TRACE(name);
    RenderSettings s = settings_at(2.5, GetParam());
    s.camera.fov_deg = 5;
    expect_true(subject(name).open(), s, 44, name == "MakeHuman" || name == "ICT");
  }
}

// All triangles of a pixel against one entry for each surface.
TEST_P(Shading, OfAHeadFarAway) {
  for (const std::string name : {"built-in head", "scan"}) {
    if (!subject(name).missing.empty()) continue;
    SCOPED_TRACE(name);
    RenderSettings s = settings_at(50, GetParam());
    s.output.width = s.output.height = 96;
    s.camera.fov_deg = 6;
    expect_true(subject(name).open(), s, 25);
  }
}

TEST_P(Shading, OfFourHeads) {
  RenderSettings s = settings_at(5, GetParam());
  s.camera.heads = 4;
  s.output.width = 320;
  expect_true(subject("built-in head").open(), s, 36, true);
}

TEST_P(Shading, WithOneSample) {
  RenderSettings s = settings_at(2.5, GetParam());
  s.quality.samples = 1;
  expect_true(subject("built-in head").open(), s, 38, true);
}

// The order of the lists changes from run to run; the picture does not.
TEST_P(Shading, TwoRunsAreEqualToTheBit) {
  for (const double distance : {2.5, 20.0}) {
    const RenderSettings s = settings_at(distance, GetParam());
    const Scene& scene = subject("built-in head").open();
    const Picture first = renderer().render(scene, s);
    for (int i = 0; i < 3; ++i) {
      const Picture again = renderer().render(scene, s);
      ASSERT_EQ(first.linear_rgba.size(), again.linear_rgba.size());
      EXPECT_EQ(std::memcmp(first.linear_rgba.data(), again.linear_rgba.data(),
                            first.linear_rgba.size() * sizeof(float)),
                0);
    }
  }
}

// Without perspective: the depth is linear, and rays are parallel.
TEST_P(Shading, WithoutPerspective) {
  scene::AssetData made = scene::sphere(0.1, 48);
  made.cameras.push_back(camera_from_above(0.11, {0, 0, 0.5f}));
  made.lights.push_back(directional_light({-0.5f, -0.3f, -0.6f}, glm::vec3(3)));
  RenderSettings s = settings_at(1, GetParam());
  s.camera.distance.reset();
  s.camera.name = "above";
  expect_true(wrap(std::move(made)), s, 41);
}

// A checkered sphere: its far side is seen through the near one, both sides of it are skin.
scene::AssetData checkered_sphere() {
  scene::AssetData made = scene::sphere(0.1, 48);
  image::Image8 pixels{.width = 64, .height = 64, .rgba = {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const auto there = static_cast<std::uint8_t>((x / 4 + y / 4) % 2 ? 255 : 0);
      pixels.rgba.insert(pixels.rgba.end(), {200, 150, 130, there});
    }
  scene::Material& skin = made.materials.front();
  skin.alpha_mode = AssetAlpha::mask;
  skin.double_sided = true;
  skin.base_colour_map.image = 0;
  skin.base_colour_map.nearest = true;
  made.images.push_back({.name = "mask", .pixels = std::make_shared<const image::Image8>(std::move(pixels))});
  return made;
}

TEST_P(Shading, OfSkinWithAnAlphaTest) {
  expect_true(wrap(checkered_sphere()), settings_at(3, GetParam()), 32);
}

// Two balls of one head, of other materials and profiles, one before the other; and over them what is no
// skin, opaque and blended.
scene::AssetData two_skins(bool covered) {
  scene::AssetData made = scene::sphere(0.1, 32), front = scene::sphere(0.05, 32);
  const auto add = [&](scene::AssetData& other, const glm::vec3& at, const scene::Material& material) {
    scene::Primitive p = other.primitives.front();
    p.material = static_cast<int>(made.materials.size());
    p.node = p.material;
    for (scene::Vertex& v : p.vertices) v.position_m += at;
    made.materials.push_back(material);
    made.primitives.push_back(std::move(p));
  };

  scene::Material pale = made.materials.front();
  ScatterProfile wide;
  wide.name = "wide";
  wide.terms = {{.variance_mm2 = 4, .weight = {0.5, 0.8, 0.9}},
                {.variance_mm2 = 40, .weight = {0.5, 0.2, 0.1}}};
  pale.name = "pale";
  pale.base_colour = {0.9f, 0.8f, 0.7f, 1};
  pale.skin_settings.profile = wide;
  add(front, {0.05f, 0.03f, 0.12f}, pale);

  if (covered) {
    scene::Material glass;
    glass.name = "glass";
    glass.base_colour = {0.2f, 0.5f, 0.9f, 0.4f};
    glass.alpha_mode = AssetAlpha::blend;
    add(front, {-0.04f, 0.05f, 0.1f}, glass);

    scene::Material stone;
    stone.name = "stone";
    stone.base_colour = {0.1f, 0.6f, 0.2f, 1};
    add(front, {0.02f, -0.07f, 0.08f}, stone);
  }
  return made;
}

TEST_P(Shading, OfSeveralSkins) { expect_true(wrap(two_skins(false)), settings_at(3, GetParam()), 41); }

TEST_P(Shading, UnderWhatIsNotSkin) {
  for (const int samples : {4, 1}) {
    RenderSettings s = settings_at(3, GetParam());
    s.quality.samples = samples;
    expect_true(wrap(two_skins(true)), s, 38, true);
  }
}

TEST_P(Shading, IsWhiteInAWhiteFurnace) {
  const Picture p = renderer().render(subject("built-in head").open(), furnace_settings(GetParam(), true));
  const SkinRange skin = skin_range(p);
  EXPECT_GT(skin.pixels, 1000u);
  EXPECT_GE(skin.low, 0.98f);
  EXPECT_LE(skin.high, 1.02f);
}

// Heads in batches: the ids of all are there before the light of any.
TEST(ShadingInBatches, IsThatOfAllHeadsAtOnce) {
  RenderSettings s = settings_at(6);
  s.camera.heads = 4;
  s.output.width = 320;
  s.quality.map_budget_mb = 100;
  const Picture at_once = renderer().render(subject("built-in head").open(), s);
  s.quality.map_budget_mb = 3;
  const Picture in_batches = renderer().render(subject("built-in head").open(), s);
  EXPECT_GT(in_batches.statistics.passes.size(), 2 * at_once.statistics.passes.size());
  EXPECT_EQ(in_batches.linear_rgba, at_once.linear_rgba);
}

// Small pictures hold as much light as the truth, also of rims that are lit from behind: those are hardly
// wider than a pixel.
TEST(ShadingOfSmallHeads, HoldsTheirLight) {
  const Scene& scene = subject("built-in head").open();
  for (const std::string technique : {"texture-space", "lambert"})
    for (const bool from_behind : {false, true}) {
      RenderSettings s = settings_at(from_behind ? 3.3 : 8, technique);
      s.output.width = 54, s.output.height = from_behind ? 48 : 24;
      s.camera.heads = from_behind ? 1 : 4;
      if (from_behind) {
        s.lighting.placed_lights = {{.azimuth_deg = 178, .elevation_deg = 8, .irradiance = 40}};
        s.lighting.ambient = 0;
      }
      const double share = light_of(linear(renderer().render(scene, s))) / light_of(truth_of(scene, s, 8));
      std::printf("%s, %s: %.3f of the light\n", technique.c_str(),
                  from_behind ? "lit from behind" : "four heads", share);
      EXPECT_NEAR(share, 1, from_behind ? 0.4 : 0.02);
    }
}

// Squares of half a pixel in four colours, each at a distance of its own: one under each sample of a pixel.
// `parts`: of a material each; else of one part, and told apart by distance alone.
scene::AssetData four_surfaces_per_pixel(int pixels, bool parts) {
  const glm::vec3 colours[] = {
      {0.9f, 0.1f, 0.1f}, {0.1f, 0.9f, 0.1f}, {0.1f, 0.1f, 0.9f}, {0.9f, 0.9f, 0.1f}};
  const float pixel_m = 0.1f;
  const scene::AssetData square = scene::plane(pixel_m / 2);
  scene::AssetData made = square;
  made.primitives.clear();

  const auto add = [&](int x, int y, int number) {
    const glm::vec2 pixel = glm::vec2(x, y) - 0.5f * static_cast<float>(pixels),
                    quarter = 0.25f + 0.5f * glm::vec2(number % 2, number / 2);
    scene::Primitive p = square.primitives.front();
    p.material = parts ? number : 0;

    for (scene::Vertex& v : p.vertices) {
      v.position_m += glm::vec3(pixel_m * (pixel + quarter), -static_cast<float>(number));
      v.uv0 = (v.uv0 + glm::vec2(x + pixels * number, y)) / static_cast<float>(4 * pixels);
      if (!parts) v.colour = glm::vec4(colours[number], 1);
    }
    made.primitives.push_back(std::move(p));
  };

  for (int number = 0; number < 4; ++number) {
    if (number > 0) made.materials.push_back(square.materials.front());
    if (parts) made.materials.back().base_colour = glm::vec4(colours[number], 1);
    for (int y = 0; y < pixels; ++y)
      for (int x = 0; x < pixels; ++x) add(x, y, number);
  }
  made.cameras.push_back(camera_from_above(pixel_m / 2 * static_cast<float>(pixels), {0, 0, 1}));
  return made;
}

TEST(ShadingOfEntries, EachSurfaceOfAPixelIsShaded) {
  for (const bool parts : {false, true}) {
    SCOPED_TRACE(parts ? "of four parts" : "of one part");
    RenderSettings s = settings_at(1, "lambert");
    s.camera.distance.reset();
    s.camera.name = "above";
    s.output.width = s.output.height = 16;
    s.lighting.ambient = 1, s.lighting.rig_lights = 0, s.lighting.specular = false;

    const Picture picture = renderer().render(wrap(four_surfaces_per_pixel(16, parts)), s);
    for (std::size_t i = 0; i < picture.linear_rgba.size(); i += 4) {
      EXPECT_NEAR(picture.linear_rgba[i], 0.5, 0.01);
      EXPECT_NEAR(picture.linear_rgba[i + 1], 0.5, 0.01);
      EXPECT_NEAR(picture.linear_rgba[i + 2], 0.3, 0.01);
      EXPECT_EQ(picture.linear_rgba[i + 3], 1);
    }
  }
}

// Two squares that meet in a hollow fold at an angle to the rows of pixels, under light that shines into it.
scene::AssetData fold() {
  const float side_m = 0.1f, bend = glm::radians(50.0f);
  scene::AssetData made = two_planes(side_m, 8, [&](scene::Vertex& v) {
    const float from_fold_m = v.position_m.x + side_m / 2;
    v.position_m = {side_m / 2 + std::cos(bend) * from_fold_m, v.position_m.y, std::sin(bend) * from_fold_m};
    v.normal = {-std::sin(bend), 0, std::cos(bend)};
    v.tangent = glm::vec4(std::cos(bend), 0, std::sin(bend), 1);
  });

  const glm::mat3 turn(glm::rotate(glm::mat4(1), glm::radians(10.0f), glm::vec3(0, 0, 1)));
  for (scene::Vertex& v : made.primitives.front().vertices) {
    v.position_m = turn * (v.position_m - glm::vec3(side_m / 2, 0, 0));
    v.normal = turn * v.normal;
    v.tangent = glm::vec4(turn * glm::vec3(v.tangent), v.tangent.w);
  }

  made.lights = {directional_light(turn * -glm::vec3(-std::sin(bend / 2), 0, std::cos(bend / 2)))};
  made.cameras.push_back(camera_from_above(0.04, {0, 0, 1}));
  return made;
}

// A pixel of both squares is shaded at one point, beside the square that it takes: not below the other one.
TEST(ShadingOfEntries, AFoldIsNotInItsOwnShadow) {
  // Fine maps are those of many pixels.
  for (const auto& [pixels, shadow_side] : {std::pair{48, 512}, std::pair{700, 4096}}) {
    SCOPED_TRACE(shadow_side);
    RenderSettings s = under_lamps_alone(settings_at(1, "lambert"));
    s.camera.distance.reset();
    s.camera.name = "above";
    s.output.width = s.output.height = pixels;
    s.quality.shadow_size = shadow_side;

    const SkinRange range = skin_range(renderer().render(wrap(fold()), s));
    EXPECT_GT(range.pixels, 1500u);
    EXPECT_GT(range.low, 0.97f * range.high);
  }
}

// A run of more triangles than ids of a part can number is several parts: where one ends, nothing shows.
TEST(ShadingOfParts, OfAMeshWithMoreTrianglesThanAPart) {
  scene::AssetData fine = scene::sphere(0.1, 200);
  ASSERT_GT(fine.primitives.front().indices.size() / 3, std::size_t{1} << ID_TRIANGLE_BITS);
  for (const std::string technique : {"lambert", "separable"}) {
    RenderSettings s = settings_at(3, technique);
    s.output.width = s.output.height = 128;
    const Picture found = renderer().render(wrap(scene::AssetData(fine)), s),
                  wanted = renderer().render(wrap(scene::sphere(0.1, 120)), s);
    const double db = image::psnr_db(shown(wanted), shown(found), skin_mask(wanted));
    std::printf("%s: %.1f dB\n", technique.c_str(), db);
    EXPECT_GE(db, 40) << write_failure(linear(wanted), linear(found));
  }
}

// Balls of several materials.
TEST(ShadingOfParts, OfMoreThanTwelveBitsCanNumber) {
  scene::AssetData balls = scene::sphere(0.1, 4);
  const scene::Primitive ball = balls.primitives.front();
  for (int k = 1; k < 5; ++k) {
    balls.materials.push_back(balls.materials.front());
    balls.primitives.push_back(ball);
    balls.primitives.back().material = k;
    for (scene::Vertex& v : balls.primitives.back().vertices) v.position_m.y += 0.2f * static_cast<float>(k);
  }
  RenderSettings s = settings_at(40, "lambert");
  s.camera.heads = 1024;
  s.output.width = 1024, s.output.height = 32;
  s.quality.shadow_size = 32;
  s.lighting.ambient = 1, s.lighting.rig_lights = 0, s.lighting.specular = false;
  const SkinRange range = skin_range(renderer().render(wrap(std::move(balls)), s));
  EXPECT_GT(range.pixels, 700u);
  EXPECT_GT(range.low, 0.9f * range.high) << "some of it is not shaded";
}

// A picture of more pixels than a list holds is listed in bands; a part of it is a picture of its own.
TEST(ShadingOfParts, OfAPictureOfSeveralBands) {
  RenderSettings s = settings_at(2.5, "lambert");
  s.output.width = 4096, s.output.height = 2304;
  s.quality.samples = 1;
  ASSERT_GT(s.output.width * s.output.height, MOST_BAND_PIXELS);
  const Scene& scene = subject("built-in head").open();
  const Picture large = renderer().render(scene, s);
  s.output.width /= 4, s.output.height /= 4;
  s.quality.samples = 4;
  const Picture small = renderer().render(scene, s);
  const double db = image::psnr_db(shown(small), shown(downsampled(large, 4)), skin_mask(small));
  std::printf("%.1f dB\n", db);
  EXPECT_GE(db, 40);
}

}  // namespace
}  // namespace dermis::tests
