// SPDX-License-Identifier: MIT
#include "render/passes/shadow/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "head/scene/framing.h"
#include "head/scene/surface/enclosure.h"

namespace dermis::passes {
namespace {

constexpr int map_size = 1024;

/// A flat, tilted cloud of points: far from a ball, and not along the axes.
std::vector<glm::vec3> slanted_points() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<glm::vec3> points;
  for (int i = 0; i < 2000; ++i) {
    const float a = unit(random), b = unit(random), c = unit(random);
    points.emplace_back(0.3f + 0.20f * a + 0.05f * b, 1.0f + 0.06f * a - 0.15f * b, -0.2f + 0.04f * c);
  }
  return points;
}

struct Body {
  std::vector<glm::vec3> points_m = slanted_points(), corners_m = scene::enclosing_corners(points_m);
  scene::BoundingSphere sphere = scene::bounding_sphere(points_m);

  ShadowBounds tight() const { return {sphere, corners_m}; }
  ShadowBounds loose() const { return {sphere, {}}; }
};

std::vector<glm::vec3> directions() {
  std::vector<glm::vec3> found;
  for (const double elevation_deg : {-90.0, -40.0, 0.0, 10.0, 63.0, 65.0, 90.0})
    for (double azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 30)
      found.emplace_back(-scene::head_direction(azimuth_deg, elevation_deg));
  return found;
}

scene::Light sun(const glm::vec3& direction) {
  scene::Light light;
  light.type = LightType::directional;
  light.direction = direction;
  return light;
}

scene::Light lamp(const Body& body, const glm::vec3& direction, float distance_radii) {
  scene::Light light;
  light.type = LightType::spot;
  light.direction = direction;
  light.position_m = body.sphere.centre_m - direction * (distance_radii * body.sphere.radius_m);
  return light;
}

/// All points lie in the map, at least three texels from its borders, between near and far.
void expect_holds(const ShadowFit& fit, const Body& body) {
  ASSERT_EQ(fit.shadow_from_world.size(), 1u);
  const float most = 1 - 2 * 3.0f / map_size;
  for (const glm::vec3& p_m : body.points_m) {
    const glm::vec4 clip = fit.shadow_from_world[0] * glm::vec4(p_m, 1);
    ASSERT_GT(clip.w, 0);
    EXPECT_LE(std::max(std::abs(clip.x), std::abs(clip.y)), most * clip.w);
    EXPECT_GT(clip.z, 0);
    EXPECT_LT(clip.z, clip.w);
  }
}

/// Returns the distance of two points in the world that lie a texel apart in the middle of the map, at
/// `depth`.
double texel_m(const ShadowFit& fit, float depth) {
  const glm::mat4 world = glm::inverse(fit.shadow_from_world[0]);
  const glm::vec4 a = world * glm::vec4(0, 0, depth, 1), b = world * glm::vec4(2.0f / map_size, 0, depth, 1);
  return glm::distance(glm::vec3(a) / a.w, glm::vec3(b) / b.w);
}

TEST(ShadowFit, HoldsAllThatCastsAShadow) {
  const Body body;
  for (const glm::vec3& direction : directions()) {
    expect_holds(fit_shadow(sun(direction), body.tight(), map_size), body);
    expect_holds(fit_shadow(sun(direction), body.loose(), map_size), body);
    for (const float distance_radii : {1.2f, 2.0f, 4.0f, 50.0f}) {
      expect_holds(fit_shadow(lamp(body, direction, distance_radii), body.tight(), map_size), body);
      expect_holds(fit_shadow(lamp(body, direction, distance_radii), body.loose(), map_size), body);
    }
  }
}

// The stated texel is the one that the matrix has.
TEST(ShadowFit, SaysHowLargeATexelIs) {
  const Body body;
  for (const glm::vec3& direction : directions()) {
    const ShadowFit of_sun = fit_shadow(sun(direction), body.tight(), map_size);
    EXPECT_NEAR(texel_m(of_sun, 0.5f) / of_sun.texel, 1, 1e-3);

    const scene::Light spot = lamp(body, direction, 3);
    const ShadowFit of_lamp = fit_shadow(spot, body.tight(), map_size);
    const glm::vec4 middle = glm::inverse(of_lamp.shadow_from_world[0]) * glm::vec4(0, 0, 0.5f, 1);
    const float distance_m = glm::distance(glm::vec3(middle) / middle.w, spot.position_m);
    EXPECT_NEAR(texel_m(of_lamp, 0.5f) / (of_lamp.texel * distance_m), 1, 1e-3);
  }
}

// Texels are never larger than those of a fit to the sphere, and on a flat body much smaller: its sides are
// 0.4 m and 0.3 m where the sphere has 0.53 m across.
TEST(ShadowFit, IsTighterThanTheSphere) {
  const Body body;
  double sum = 0;
  for (const glm::vec3& direction : directions()) {
    const float loose = fit_shadow(sun(direction), body.loose(), map_size).texel;
    const float tight = fit_shadow(sun(direction), body.tight(), map_size).texel;
    EXPECT_LE(tight, loose);
    sum += tight / loose;

    const scene::Light spot = lamp(body, direction, 4);
    EXPECT_LE(fit_shadow(spot, body.tight(), map_size).texel, fit_shadow(spot, body.loose(), map_size).texel);
  }
  EXPECT_LE(sum / static_cast<double>(directions().size()), 0.8);
}

// A square turns with what it holds: a long body needs its diagonal alone.
TEST(ShadowFit, TurnsTheMap) {
  std::vector<glm::vec3> points;
  for (int i = -100; i <= 100; ++i) points.emplace_back(0.001f * static_cast<float>(i), 0.f, 0.f);
  const std::vector<glm::vec3> corners = scene::enclosing_corners(points);
  const ShadowFit fit = fit_shadow(sun({0, 0, -1}), {scene::bounding_sphere(points), corners}, map_size);
  EXPECT_NEAR(fit.texel * map_size, 0.2 / std::sqrt(2.0), 0.002);
}

TEST(ShadowFit, OfNothingAndOfAPoint) {
  const scene::BoundingSphere point{{1, 2, 3}, 0};
  const std::vector<glm::vec3> corners{{1, 2, 3}};
  const ShadowFit fit = fit_shadow(sun({0, -1, 0}), {point, corners}, map_size);
  EXPECT_GT(fit.texel, 0);
  EXPECT_TRUE(std::isfinite(fit.texel));
}

TEST(ShadowFit, SixLayersAroundALightInside) {
  const Body body;
  scene::Light light;
  light.type = LightType::point;
  light.position_m = body.sphere.centre_m;
  EXPECT_EQ(fit_shadow(light, body.tight(), map_size).shadow_from_world.size(), 6u);
}

}  // namespace
}  // namespace dermis::passes
