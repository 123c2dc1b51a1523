// SPDX-License-Identifier: MIT
// An instance shows its asset as if it had been made where it stands, and does not see the others.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "api/asset_state.h"
#include "api/scene_state.h"
#include "dermis/error.h"
#include "dermis/renderer.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/assets.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

using Matrix = std::array<double, 16>;

// Turned about an axis that lies along none, scaled, then moved.
Matrix transform(double angle_deg, double scale, const glm::dvec3& origin_m,
                 const glm::dvec3& axis = {0.3, 0.9, -0.2}) {
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), glm::radians(angle_deg), glm::normalize(axis));
  Matrix m{};
  for (glm::length_t c = 0; c < 3; ++c)
    for (glm::length_t r = 0; r < 3; ++r) m[static_cast<std::size_t>(4 * c + r)] = scale * turned[c][r];
  for (glm::length_t r = 0; r < 3; ++r) m[static_cast<std::size_t>(12 + r)] = origin_m[r];
  m[15] = 1;
  return m;
}

// The light of every kind, in the world.
void add_lights(Scene& scene) {
  scene.add_light(
      {.light = {.type = LightType::directional, .colour = {1, 0.9, 0.8}, .direction = {-1, -1, -2}}});
  scene.add_light({.light = {.type = LightType::spot,
                             .colour = {0.3, 0.3, 0.4},
                             .position_m = {-0.5, 0.2, 0.4},
                             .direction = {0.5, -0.2, -0.4},
                             .inner_cone_deg = 20,
                             .outer_cone_deg = 40}});
  scene.add_light(
      {.light = {.type = LightType::point, .colour = {0.2, 0.3, 0.2}, .position_m = {0.4, 0.3, -0.5}}});
}

RenderSettings settings_for(int side) {
  RenderSettings s = small_settings("texture-space", side, 128);
  s.output.exposure_ev = 0;
  s.output.bloom = 0;
  s.camera.eye_m = {0.1, 0.05, 0.7};
  s.camera.target_m = {0, 0, 0};
  return s;
}

Asset head() {
  static const Asset asset = Asset::built_in();
  return asset;
}

// The same scene as one asset, its vertices in the world.
Scene flattened(const Scene& scene) {
  Scene flat;
  flat.add({.asset = Asset::State::make(scene::measured(*setup::flattened(api::placed_scene(scene))))});
  for (const LightId id : scene.lights()) flat.add_light(scene.light(id));
  return flat;
}

// How far two pictures are apart over pixels that `mask` has, as a share of the greater value.
double largest_difference(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask) {
  double largest = 0;
  for (std::size_t i = 0; i < a.linear_rgba.size(); ++i) {
    if (!mask[i / 4]) continue;
    const double x = a.linear_rgba[i], y = b.linear_rgba[i];
    largest = std::max(largest, std::abs(x - y) / std::max({std::abs(x), std::abs(y), 0.01}));
  }
  return largest;
}

std::size_t count(const std::vector<std::uint8_t>& mask) {
  return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1));
}

// Values over pixels that `mask` has, that are apart by more than this share of the greater one.
std::size_t differing(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask,
                      double share) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < a.linear_rgba.size(); ++i) {
    const double x = a.linear_rgba[i], y = b.linear_rgba[i];
    if (mask[i / 4] && std::abs(x - y) > share * std::max({std::abs(x), std::abs(y), 0.01})) ++found;
  }
  std::printf("%zu values of %zu pixels differ\n", found, count(mask));
  return found;
}

ScatterProfile profile_of(double variance_mm2) {
  return {.name = "made up",
          .model = "none",
          .terms = {{variance_mm2 / 8, {0.4, 0.5, 0.6}}, {variance_mm2, {0.6, 0.5, 0.4}}},
          .total_reflectance = {0.7, 0.6, 0.5}};
}

// Vertices are turned on the device instead of in a file: roundings remain, and, under an environment, other
// rays of the bake.
TEST(Instances, ShowTheirAssetWhereTheyStand) {
  Scene scene;
  scene.add({.asset = head(), .world_from_asset = transform(35, 0.7, {0.02, -0.03, 0.01})});
  add_lights(scene);

  for (const char* environment : {"", "studio"})
    for (const char* technique : {"texture-space", "lambert"}) {
      RenderSettings s = settings_for(128);
      s.technique = technique;
      s.quality.shadow_size = 2048;  // the shadow maps lie otherwise
      s.lighting.environment = environment;
      SCOPED_TRACE(std::string(technique) + " " + environment);
      const Picture made = renderer().render(flattened(scene), s), placed = renderer().render(scene, s);
      expect_unseen(made, placed);

      // A tangent that is not turned leaves 987 values without an environment.
      const std::vector<std::uint8_t> mask = skin_mask(made, 0.999f);
      if (!*environment) { EXPECT_LT(differing(made, placed, mask, 0.01), count(mask) / 8); }
    }
}

// A head of half the size whose profile is half as wide is the same picture from half as far.
TEST(Instances, ScaleLeavesMillimetresOfSkinAsTheyAre) {
  const auto picture_of = [](double scale) {
    Scene scene;
    scene.add({.asset = head(),
               .world_from_asset = transform(0, scale, {0, 0, 0}),
               .profile = profile_of(4 * scale * scale)});
    scene.add_light({.light = {.colour = {1, 1, 1}, .direction = {-1, -0.5, -0.3}}});
    RenderSettings s = settings_for(96);
    s.camera.eye_m = {0.1 * scale, 0, 0.6 * scale};
    s.output.exposure_ev = 0;
    return renderer().render(scene, s);
  };

  const Picture whole = picture_of(1), half = picture_of(0.5);
  EXPECT_LT(largest_difference(whole, half, skin_mask(whole, 0.999f)), 4 * half_rounding);

  // The same profile spreads light over twice as much of the smaller head.
  Scene scene;
  scene.add({.asset = head(), .world_from_asset = transform(0, 0.5, {0, 0, 0}), .profile = profile_of(4)});
  scene.add_light({.light = {.colour = {1, 1, 1}, .direction = {-1, -0.5, -0.3}}});
  RenderSettings s = settings_for(96);
  s.camera.eye_m = {0.05, 0, 0.3};
  EXPECT_GT(largest_difference(half, renderer().render(scene, s), skin_mask(half, 0.999f)), 0.05);
}

// What a head has in a scene of its own lies elsewhere in the maps that heads share: coordinates round.
constexpr double elsewhere_in_the_maps = 4 * half_rounding;

// Each of several instances, of two assets with profiles, mixes, tints and scales of their own, is drawn as
// if it were alone.
TEST(Instances, DoNotSeeEachOther) {
  const Asset ball = Asset::State::make(scene::measured(scene::sphere(0.06)));
  Scene scene;
  for (int i = 0; i < 6; ++i)
    scene.add({.asset = i % 3 == 2 ? ball : head(),
               .world_from_asset = transform(25.0 * i, 0.4 + 0.1 * (i % 2),
                                             {0.16 * (i % 3) - 0.16, 0.2 * (i / 3) - 0.1, 0}, {0, 1, 0}),
               .profile = i % 2 ? std::optional(profile_of(1 + i)) : std::nullopt,
               .mix = i % 3 == 1 ? std::optional(0.2) : std::nullopt,
               .tint = {1, 1 - 0.1 * i, 1 - 0.15 * i}});
  add_lights(scene);

  for (const bool all_at_once : {true, false}) {
    RenderSettings s = settings_for(160);
    s.camera.eye_m = {0.1, 0.05, 1.6};
    if (!all_at_once) s.quality.map_budget_mb = 4;
    const Picture together = renderer().render(scene, s);
    EXPECT_EQ(together.statistics.heads, 6);

    std::size_t covered = 0;
    for (const InstanceId shown : scene.instances()) {
      Scene alone = scene;
      for (const InstanceId id : scene.instances())
        if (id != shown) alone.remove(id);
      const Picture one = renderer().render(alone, s);
      const std::vector<std::uint8_t> mask = skin_mask(one, 0.999f);
      EXPECT_GT(count(mask), 100u);
      EXPECT_LT(largest_difference(together, one, mask), elsewhere_in_the_maps) << static_cast<int>(shown);
      covered += count(mask);
    }
    EXPECT_EQ(covered, count(skin_mask(together, 0.999f)));
  }
}

// 16 x 16 heads of six people, each with its pose and profile, some behind others at their edges.
TEST(Instances, ACrowdIsItsHeads) {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"african-man-old", "african-man-young", "asian-woman-young", "european-man-young",
                           "european-woman-young", "south-asian-man-middleage"})
    files.push_back(asset_cache() / "makehuman" / "crowd" / ("mh-crowd-" + std::string(name) + "-lod2.glb"));
  if (const std::string missing = missing_asset(files); !missing.empty()) GTEST_SKIP() << missing;
  std::vector<Asset> people;
  for (const std::filesystem::path& file : files) people.push_back(Asset::load(file));

  Scene scene;
  for (int i = 0; i < 256; ++i)
    scene.add({.asset = people[static_cast<std::size_t>(i % 6)],
               .world_from_asset = transform(7.0 * (i % 11) - 35, 0.9 + 0.01 * (i % 7),
                                             {0.3 * (i % 16 - 7.5), 0.4 * (i / 16 - 7.5), 0}, {0, 1, 0}),
               .profile = profile_of(1 + 0.01 * i)});
  add_lights(scene);
  RenderSettings s = settings_for(384);
  s.quality.map_size = s.quality.shadow_size = 64;
  s.camera.eye_m = {0, 0, 18};
  PreparedFrame crowd = renderer().prepare(scene, s);
  const Picture together = crowd.picture();
  EXPECT_EQ(together.statistics.heads, 256);

  PreparedFrame frame = renderer().prepare(scene, s);
  std::vector<int> owners(together.linear_rgba.size() / 4, 0);
  std::size_t compared = 0;
  std::vector<Picture> pictures;
  for (const InstanceId shown : scene.instances()) {
    Scene alone;
    alone.add(scene.instance(shown));
    add_lights(alone);
    frame.set(alone, s);
    pictures.push_back(frame.picture());
    for (std::size_t p = 0; p < owners.size(); ++p) owners[p] += pictures.back().linear_rgba[4 * p + 3] > 0;
  }
  for (const Picture& one : pictures) {
    std::vector<std::uint8_t> mask = skin_mask(one, 0.999f);
    for (std::size_t p = 0; p < mask.size(); ++p) mask[p] = mask[p] && owners[p] == 1;
    compared += count(mask);
    EXPECT_LT(largest_difference(together, one, mask), elsewhere_in_the_maps);
  }
  std::printf("%zu pixels of 256 heads compared\n", compared);
  EXPECT_GT(compared, 10'000u);
}

// A row of one asset by the settings is the row by its instances.
TEST(Instances, OfARowAreItsHeads) {
  RenderSettings s = settings_for(128);
  s.camera.eye_m = {0.1, 0, 1.4};
  Scene one(head());
  add_lights(one);
  RenderSettings row = s;
  row.camera.heads = 3;

  Scene three;
  const double radius_m = static_cast<double>(api::only_asset(one).bounds.sphere.radius_m);
  for (int i = 0; i < 3; ++i)
    three.add({.asset = head(),
               .world_from_asset = transform(
                   0, 1, {static_cast<double>(static_cast<float>(1.6 * radius_m * (i - 1))), 0, 0})});
  add_lights(three);
  expect_equal_bits(renderer().render(one, row), renderer().render(three, s));

  EXPECT_NE(thrown<InputError>([&] { renderer().render(three, row); }).find("camera.heads must be 1"),
            std::string::npos);
}

TEST(Instances, CarryTheLightsOfTheirRig) {
  const Light lamp{.type = LightType::spot,
                   .colour = {0.5, 0.5, 0.5},
                   .position_m = {0.3, 0.2, 0.4},
                   .direction = {-0.3, -0.2, -0.4},
                   .range_m = 2,
                   .inner_cone_deg = 15,
                   .outer_cone_deg = 25};
  const auto picture_of = [&](const Matrix& pose, const std::array<double, 3>& eye, double scale) {
    Scene scene;
    const InstanceId id =
        scene.add({.asset = head(), .world_from_asset = pose, .profile = profile_of(4 * scale * scale)});
    scene.add_light({.light = lamp, .rig = id});
    RenderSettings s = settings_for(96);
    s.camera.eye_m = eye;
    return renderer().render(scene, s);
  };

  // Half a turn about the vertical: the camera turns with the head.
  const Picture before = picture_of(transform(0, 1, {0, 0, 0}), {0, 0, 0.7}, 1);
  const Picture behind = picture_of(transform(180, 1, {0, 0, 0}, {0, 1, 0}), {0, 0, -0.7}, 1);
  expect_unseen(before, behind);
  const Picture small = picture_of(transform(0, 0.5, {0, 0, 0}), {0, 0, 0.35}, 0.5);
  EXPECT_LT(largest_difference(before, small, skin_mask(before, 0.999f)), 8 * half_rounding);
}

TEST(Instances, AFrameFollowsItsScene) {
  Scene scene;
  const InstanceId id = scene.add({.asset = head()});
  add_lights(scene);
  const RenderSettings s = settings_for(64);
  PreparedFrame frame = renderer().prepare(scene, s);
  const Picture before = frame.picture();

  scene.set_transform(id, transform(60, 1, {0.02, 0, 0}, {0, 1, 0}));
  scene.set_tint(id, {0.5, 0.4, 0.3});
  EXPECT_EQ(frame.picture().linear_rgba, before.linear_rgba) << "an edit is seen when it is set";
  frame.set(scene, s);
  const Picture after = frame.picture();
  EXPECT_NE(after.linear_rgba, before.linear_rgba);
  expect_equal_bits(renderer().render(scene, s), after);

  // What changed back is as it was.
  scene.set_transform(id, transform(0, 1, {0, 0, 0}));
  scene.set_tint(id, {1, 1, 1});
  frame.set(scene, s);
  expect_equal_bits(before, frame.picture());
}

TEST(Instances, AnEnvironmentOfPixelsIsThatOfTheFile) {
  SceneEnvironment pixels{.width = 8, .height = 4};
  auto rgb = std::make_shared<std::vector<float>>(8 * 4 * 3, 0.2f);
  for (int i = 0; i < 3; ++i) (*rgb)[static_cast<std::size_t>(3 * (8 + 5) + i)] = 2.0f;
  pixels.rgb = rgb;
  Scene scene(Asset::State::make(scene::measured(scene::sphere(0.06))));
  RenderSettings s = settings_for(48);
  s.lighting.rig_lights = 0;
  const Picture uniform = renderer().render(scene, s);
  scene.set_environment(pixels);
  const Picture lit = renderer().render(scene, s);
  EXPECT_GT(skin_range(lit).mean[0], 2 * skin_range(uniform).mean[0]);
  EXPECT_GT(skin_range(lit).high, 1.1f * skin_range(lit).low) << "one side is brighter";
}

TEST(Instances, AnEnvironmentByNameIsThatOfTheSettings) {
  Scene scene(Asset::State::make(scene::measured(scene::sphere(0.06))));
  RenderSettings s = settings_for(48);
  s.lighting.rig_lights = 0;
  const Picture uniform = renderer().render(scene, s);
  s.lighting.environment = "studio";
  const Picture by_settings = renderer().render(scene, s);

  s.lighting.environment.clear();
  scene.set_environment(SceneEnvironment{.file = "studio"});
  expect_equal_bits(renderer().render(scene, s), by_settings);
  EXPECT_NE(uniform.linear_rgba, by_settings.linear_rgba);

  const SceneEnvironment both{
      .file = "studio", .width = 2, .height = 1, .rgb = std::make_shared<std::vector<float>>(6, 1.0f)};
  EXPECT_NE(thrown<InputError>([&] { scene.set_environment(both); }).find("exclude each other"),
            std::string::npos);
  EXPECT_NE(thrown<InputError>([&] { scene.set_environment(SceneEnvironment{}); }).find("must not be null"),
            std::string::npos);
}

}  // namespace
}  // namespace dermis::tests
