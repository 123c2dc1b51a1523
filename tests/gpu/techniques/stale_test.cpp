// SPDX-License-Identifier: MIT
// Textures of a frame begin with whatever the driver left in them. Here that is no number, which no sum, no
// weight of 0 and no clamp takes away: the picture must be the one without, to the bit.
#include <algorithm>
#include <cmath>

#include "base/settings/names.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "render/techniques/technique.h"
#include "support/rigs.h"

namespace dermis::tests {
namespace {

Renderer& poisoned_renderer() {
  static Renderer shared(Renderer::Options{.poison = true});
  return shared;
}

/// A plane whose texture coordinates end where the square of the light map does, and a ball with seams above
/// it, skin of its own, in a square of its own.
scene::AssetData plane_and_ball() {
  scene::AssetData made = scene::plane(0.2, glm::dmat2(1), {}, 4);
  const scene::AssetData ball = scene::sphere(0.05, 8);
  made.materials.push_back(ball.materials.front());
  made.primitives.push_back(ball.primitives.front());
  made.primitives.back().material = 1, made.primitives.back().node = 1;
  for (scene::Vertex& v : made.primitives.back().vertices) v.position_m.z += 0.07f;
  return made;
}

/// The same with holes in the plane, some of them at its rim.
scene::AssetData with_holes() {
  scene::AssetData made = plane_and_ball();
  image::Image8 pixels{.width = 8, .height = 8, .rgba = {}};
  for (int i = 0; i < 64; ++i) {
    const std::uint8_t there = (i % 8 + i / 8) % 3 == 0 ? 0 : 255;
    pixels.rgba.insert(pixels.rgba.end(), {255, 255, 255, there});
  }
  scene::Material& skin = made.materials.front();
  skin.alpha_mode = AssetAlpha::mask;
  skin.base_colour_map.image = static_cast<int>(made.images.size());
  made.images.push_back({.name = "mask", .pixels = std::make_shared<const image::Image8>(std::move(pixels))});
  return made;
}

void expect_same(const Picture& clean, const Picture& stale) {
  EXPECT_TRUE(std::all_of(stale.linear_rgba.begin(), stale.linear_rgba.end(),
                          [](float value) { return std::isfinite(value); }));
  expect_equal_bits(clean, stale);
  EXPECT_EQ(clean.statistics.unshaded_reads, 0u);
  EXPECT_EQ(stale.statistics.unshaded_reads, 0u);
}

/// Near: the rim of the plane fills pixels. Far: maps use a part of their squares. In a row: heads beside the
/// picture light none of theirs.
void expect_nothing_stale(const Scene& scene, RenderSettings s) {
  int smallest = s.quality.map_size;
  PreparedFrame clean = renderer().prepare(scene, s), stale = poisoned_renderer().prepare(scene, s);
  for (const auto& [distance, heads] : {std::pair(2.0, 1), {6.0, 1}, {3.0, 3}}) {
    SCOPED_TRACE(std::to_string(heads) + " heads from " + std::to_string(distance));
    s.camera.distance = distance;
    s.camera.heads = heads;
    clean.set(s), stale.set(s);
    const Picture picture = clean.picture();
    expect_same(picture, stale.picture());
    for (const int side : picture.statistics.used_size)
      if (heads == 1) smallest = std::min(smallest, side);
  }
  EXPECT_EQ(smallest < s.quality.map_size,
            s.quality.depth && techniques::find_technique(s.technique).has_light_maps)
      << "no square is used in part";
}

RenderSettings stale_settings(const std::string& technique) { return small_settings(technique, 40, 128); }

class Stale : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Techniques, Stale, testing::ValuesIn(technique_names()),
                         [](const auto& technique) { return test_name_of(technique.param); });

TEST_P(Stale, TexelsShowInNoPicture) {
  const Scene whole = wrap(plane_and_ball()), holes = wrap(with_holes());
  RenderSettings s = stale_settings(GetParam());
  for (const Scene* scene : {&whole, &holes}) {
    SCOPED_TRACE(scene == &whole ? "whole" : "with holes");
    expect_nothing_stale(*scene, s);
  }
}

// Pixels beside the heads, which nothing writes but light that was cleared: of every blur of the picture.
TEST(StaleTexels, ShowBesideNoHead) {
  const Scene whole = wrap(plane_and_ball());
  for (const std::string technique : {"screen-gaussians", "separable", "burley-disc"})
    for (const ScreenKernel kernel : {ScreenKernel::profile, ScreenKernel::published}) {
      SCOPED_TRACE(technique + " " + std::string(name_of(kernel)));
      RenderSettings s = stale_settings(technique);
      s.quality.kernel = kernel;
      s.camera.distance = 9;
      expect_same(renderer().render(whole, s), poisoned_renderer().render(whole, s));
    }
}

// Every set of optimisations.
TEST(StaleTexels, ShowWhateverIsLeftOut) {
  const Scene whole = wrap(plane_and_ball()), holes = wrap(with_holes());
  for (int set = 0; set < 8; ++set) {
    RenderSettings s = stale_settings("texture-space");
    s.quality.cull = (set & 1) != 0, s.quality.depth = (set & 2) != 0, s.quality.clip = (set & 4) != 0;
    SCOPED_TRACE(std::string(s.quality.cull ? " cull" : "") + (s.quality.depth ? " depth" : "") +
                 (s.quality.clip ? " clip" : ""));
    for (const Scene* scene : {&whole, &holes}) expect_nothing_stale(*scene, s);
  }
}

// Squares that hold one head after the other.
TEST(StaleTexels, ShowInNoBatch) {
  const Scene scene = wrap(plane_and_ball());
  RenderSettings s = stale_settings("texture-space");
  s.camera.heads = 3;
  const Statistics whole = renderer().render(scene, s).statistics;
  s.quality.map_budget_mb = 1;
  for (const double distance : {3.0, 9.0}) {
    SCOPED_TRACE(distance);
    s.camera.distance = distance;
    const Picture picture = renderer().render(scene, s);
    EXPECT_LT(picture.statistics.light_map_bytes, whole.light_map_bytes);
    expect_same(picture, poisoned_renderer().render(scene, s));
  }
}

TEST(StaleTexels, ShowInNoPose) {
  scene::AssetData made = plane_and_ball();
  made.primitives.back().placements = {{.world_from_mesh = glm::dmat4x3(1)}};
  made.rig = morphing(made, [](const glm::vec3& p) { return glm::vec3(1.3f * p.x, p.y, 0.5f * p.x); });
  Scene scene = wrap(std::move(made));
  const InstanceId id = scene.instances().front();
  RenderSettings s = stale_settings("texture-space");
  for (const double distance : {2.0, 9.0})
    for (const double weight : {0.0, 1.0}) {
      SCOPED_TRACE(std::to_string(weight) + " from " + std::to_string(distance));
      s.camera.distance = distance;
      scene.set_pose(id, RigPose{.weights = {{.name = "0", .weight = weight}}, .joints = {}});
      expect_same(renderer().render(scene, s), poisoned_renderer().render(scene, s));
    }
}

TEST(StaleTexels, ShowInNoMapsWithoutABody) {
  RenderSettings s = stale_settings("texture-space");
  s.skin.translucency = false;
  expect_nothing_stale(wrap(plane_and_ball()), s);
}

}  // namespace
}  // namespace dermis::tests
