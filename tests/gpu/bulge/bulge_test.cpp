// SPDX-License-Identifier: MIT
// A convex body does not shadow what faces the light, however coarse its triangles and fine its shadow maps:
// render/shaders/bulge.glsl. What it has of a light, less what it has of the same from behind, is then n.d
// everywhere, with d the light's direction: linear in d, so three directions of a plane check each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <glm/glm.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "api/scene_state.h"
#include "dermis/renderer.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "support/scenes.h"

namespace dermis::tests {
namespace {

constexpr float radius_m = 0.1f;

// Its edges are 30 degrees long: their middles lie 3.4 mm below the sphere, six texels of the shadow map.
scene::AssetData coarse_sphere() {
  scene::AssetData made = scene::sphere(double{radius_m}, 3);
  made.cameras = {camera_from_above(double{radius_m}, {0, 0, 0.5f})};
  return made;
}

RenderSettings plain(const std::string& technique) {
  RenderSettings s = unoptimised(small_settings(technique, 96, 192));
  s.quality.samples = 1;
  s.quality.shadow_size = 4096;
  s.skin.translucency = false;
  return under_lamps_alone(s);
}

struct Checked {
  double off = 0;          // by how much n.a + n.b misses n.(a + b), at most
  std::size_t values = 0;  // of pixels of the body, or of texels of its light map
};

// What is lit shows irradiance over pi.
Checked check(const scene::AssetData& body, const RenderSettings& settings, double scale = 1) {
  const auto picture_of = [&](const glm::vec3& to_light) {
    scene::AssetData made = body;
    made.lights = {directional_light(-to_light, glm::vec3(static_cast<float>(std::numbers::pi)))};
    Scene scene = wrap(std::move(made));
    scene.set_transform(scene.instances().front(),
                        {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, 1});
    return renderer().render(scene, settings).linear_rgba;
  };

  std::vector<double> sums;
  std::vector<bool> lit;
  const auto add = [&](const glm::vec3& direction, double weight) {
    const std::vector<float> front = picture_of(direction), back = picture_of(-direction);
    sums.resize(front.size() / 4), lit.resize(front.size() / 4);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] += weight * (double{front[4 * i]} - double{back[4 * i]});
      if (front[4 * i] > 0 || back[4 * i] > 0) lit[i] = true;
    }
  };
  // Perpendicular to each other. In the sphere's planes of symmetry no triangle would turn away too early.
  const glm::vec3 a(0.8f, 0.48f, 0.36f), b(-0.6f, 0.64f, 0.48f);
  add(a, 1);
  add(b, 1);
  add(glm::normalize(a + b), -std::numbers::sqrt2);

  Checked found;
  for (const double sum : sums) found.off = std::max(found.off, std::abs(sum));
  found.values = static_cast<std::size_t>(std::count(lit.begin(), lit.end(), true));
  return found;
}

void expect_linear(const Checked& found, std::size_t values) {
  EXPECT_GT(found.values, values);
  EXPECT_LT(found.off, 0.003);
  std::printf("off by %.4f of the light at most\n", found.off);
}

constexpr std::size_t disc = 6500;     // pixels, of pi / 4 * 96^2 a little less
constexpr std::size_t charts = 18000;  // texels, of 192^2 a little more than half

TEST(Bulge, OfPixels) { expect_linear(check(coarse_sphere(), plain("lambert")), disc); }

TEST(Bulge, OfTexels) {
  RenderSettings s = plain("texture-space");
  s.output.show = "irradiance";
  expect_linear(check(coarse_sphere(), s), charts);
}

// Light that comes through the body is found by the same read of the shadow map.
TEST(Bulge, OfTranslucentSkin) {
  RenderSettings s = plain("texture-space");
  s.output.show = "irradiance";
  s.skin.translucency = true;
  expect_linear(check(coarse_sphere(), s), charts);
}

// Light of a disc sets over an angle, and as much as sets in front rises behind: the same sum.
TEST(Bulge, UnderASoftLight) {
  RenderSettings s = plain("lambert");
  s.lighting.light_radius_m = 0.05;  // 0.4 m away: docs/techniques.md
  expect_linear(check(coarse_sphere(), s), disc);
}

TEST(Bulge, GrowsWithTheBody) {
  RenderSettings s = plain("lambert");
  expect_linear(check(coarse_sphere(), s, 3), disc);

  s = plain("texture-space");
  s.output.show = "irradiance";
  expect_linear(check(coarse_sphere(), s, 3), charts);
}

// Beside the skin, where no light meets both, stands the same in another material.
TEST(Bulge, OfWhatIsNotSkin) {
  scene::AssetData made = coarse_sphere();
  scene::Primitive other = made.primitives.front();
  for (scene::Vertex& v : other.vertices) v.position_m += glm::vec3(4 * radius_m, -4 * radius_m, 0);
  other.material = 1;
  scene::Material matt{.name = "other"};
  matt.metallic = matt.specular = 0;
  made.materials.push_back(matt);
  made.primitives.push_back(other);
  made.cameras = {camera_from_above(double{radius_m}, {4 * radius_m, -4 * radius_m, 0.5f})};

  RenderSettings s = plain("lambert");
  expect_linear(check(made, s), disc);
}

}  // namespace
}  // namespace dermis::tests
