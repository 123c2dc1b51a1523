// SPDX-License-Identifier: MIT
// Shadows of points, and penumbrae of lights with a radius: a post, an edge and a sphere in closed form, the
// scan against ground truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <numbers>

#include "api/scene_state.h"
#include "dermis/reference.h"
#include "gpu/support/failure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "image/compare_flip.h"
#include "image/metrics.h"

namespace dermis::tests {
namespace {

using std::numbers::pi;

scene::Light directional(const glm::vec3& direction, double tangent) {
  scene::Light light = directional_light(direction, glm::vec3(static_cast<float>(pi)));
  light.radius = static_cast<float>(tangent);
  return light;
}

RenderSettings plain(int width, int height) {
  RenderSettings s;
  s.technique = "lambert";
  s.output.width = width, s.output.height = height;
  s.quality.samples = 1;
  s.quality.shadow_size = 2048;
  return under_lamps_alone(s);
}

constexpr float height_m = 0.02f;

// A floor of 120 mm, and over its half x < 0 a plate `height_m` above. Light comes from that side, at 45
// degrees.
Scene plate_over_floor(double tangent) {
  scene::AssetData made =
      two_planes(0.12, 2, [](scene::Vertex& v) { v.position_m += glm::vec3(-0.06f, 0, height_m); });
  made.lights = {directional({1, 0, -1}, tangent)};
  made.cameras = {camera_from_above(0.004f, {0.03f, 0, 0.3f})};
  return wrap(std::move(made));
}

// Of the light that the floor would have without the plate. Seen from x, points u of the disc (-1 lowest, 1
// highest) are over the edge from x + h (t u - 1) / (t u + 1) = 0 on; each counts by its cosine, which goes
// as 1 + t u, and by how wide the disc is there.
double share_past_the_edge(double x_m, double tangent) {
  const double slope = x_m / double{height_m}, u = std::clamp((1 - slope) / (1 + slope) / tangent, -1.0, 1.0),
               root = std::sqrt(1 - u * u);
  return 0.5 - (u * root + std::asin(u)) / pi + tangent * 2 / (3 * pi) * root * root * root;
}

TEST(SoftShadow, OfAnEdge) {
  for (const double tangent : {0.05, 0.2, 0.5}) {
    // 1 mm per pixel along x, from 0
    const Picture picture = renderer().render(plate_over_floor(tangent), plain(60, 8));
    double worst = 0;
    for (int x = 0; x < picture.width; ++x) {
      double seen = 0;
      for (int y = 0; y < picture.height; ++y)
        seen +=
            double{picture.linear_rgba[4 * static_cast<std::size_t>(y * picture.width + x)]} / picture.height;
      const double wanted = share_past_the_edge((x + 0.5) / 1000, tangent) * std::sqrt(0.5);
      worst = std::max(worst, std::abs(seen - wanted));
    }
    std::printf("tangent %.2f: off by %.4f of the light at most\n", tangent, worst);
    // Eight directions of the disc share its light (soft_shadow.glsl): two thirds of what one of them has.
    EXPECT_LT(worst, 0.08) << tangent;
  }
}

// Nothing shades a sphere but itself, and that is in the cosine: mean over the disc of max(c + t s u, 0), s
// the sine.
TEST(SoftShadow, OfASphereIsItsHorizon) {
  for (const double tangent : {0.05, 0.2, 0.5, 3.0}) {
    scene::AssetData made = scene::sphere(0.1, 64);
    made.lights = {directional({-1, 0, 0}, tangent)};
    made.cameras = {camera_from_above(0.1f, {0, 0, 0.5f})};
    const Picture picture = renderer().render(wrap(std::move(made)), plain(200, 201));

    const int middle = picture.height / 2;
    double worst = 0;
    for (int x = 4; x < picture.width - 4; ++x) {
      const double c = (x + 0.5) / 100 - 1;
      double wanted = 0;
      for (int i = 0; i < 1000; ++i) {
        const double u = (i + 0.5) / 500 - 1;
        wanted += std::max(c + tangent * std::sqrt(1 - c * c) * u, 0.0) * 2 / pi * std::sqrt(1 - u * u) / 500;
      }

      const double seen =
          double{picture.linear_rgba[4 * static_cast<std::size_t>(middle * picture.width + x)]};
      worst = std::max(worst, std::abs(seen - wanted));
    }

    std::printf("tangent %.2f: off by %.4f of the light at most\n", tangent, worst);
    // The light changes by as much from one pixel to the next.
    EXPECT_LT(worst, 0.01) << tangent;
  }
}

// Six maps, which begin close to the light. Straight below it the plate is between, beside the plate nothing
// is.
TEST(SoftShadow, OfALightInsideTheScene) {
  for (const double radius : {0.002, 0.02, 100.0}) {
    scene::AssetData made = api::only_asset(plate_over_floor(0.1));
    scene::Light lamp;
    lamp.type = LightType::point;
    lamp.colour = glm::vec3(0.02f);
    lamp.position_m = {-0.04f, 0, 0.05f};
    lamp.radius = static_cast<float>(radius);
    made.lights = {lamp};

    const Picture picture = renderer().render(wrap(std::move(made)), plain(60, 8));
    for (const float value : picture.linear_rgba) ASSERT_TRUE(std::isfinite(value) && value >= 0);
    if (radius > 1) continue;

    // 0.5 mm beside the plate's edge, under it as the lamp sees it
    EXPECT_EQ(picture.linear_rgba[0], 0) << radius;
    const double x = 0.0595, d2 = std::pow(x + 0.04, 2) + 0.05 * 0.05;
    EXPECT_NEAR(double{picture.linear_rgba[4 * 59]}, 0.02 / d2 * 0.05 / std::sqrt(d2) / pi,
                0.02 * 0.02 / d2 / pi)
        << radius;
  }
}

// The shadow of a low post begins at its foot and is as long as the light says, at any size of the map. The
// floor has no shadow of its own.
TEST(HardShadow, OfAPostOnAFloor) {
  constexpr float post_m = 0.01f;
  for (const int side : {64, 128, 512, 2048})
    for (const double elevation_deg : {20.0, 45.0, 75.0}) {
      const double elevation = elevation_deg * pi / 180;
      scene::AssetData made = two_planes(0.12, 2, [](scene::Vertex& v) {
        v.position_m = {0, v.position_m.y, post_m * (v.position_m.x / 0.12f + 0.5f)};
        v.normal = {-1, 0, 0};
      });
      made.lights = {directional({std::cos(elevation), 0, -std::sin(elevation)}, 0)};
      made.cameras = {camera_from_above(0.004f, {0, 0, 0.3f})};
      RenderSettings s = plain(480, 32);  // 0.25 mm per pixel along x, from -60 mm
      s.quality.shadow_size = side;
      const Picture picture = renderer().render(wrap(std::move(made)), s);

      const double texel_m = 0.17 / side, reach_m = post_m / std::tan(elevation),
                   filter_m = 2.5 * texel_m / std::sin(elevation);
      double dark_m = 0.5e-3;
      for (int x = 0; x < picture.width; ++x) {
        const double x_m = (x + 0.5) * 0.25e-3 - 0.06;
        if (std::abs(x_m) < 0.5e-3) continue;  // the post itself
        const double lit = double{picture.linear_rgba[4 * static_cast<std::size_t>(x)]} / std::sin(elevation);
        if (x_m > 0) dark_m += (1 - lit) * 0.25e-3;
        if (x_m < -filter_m || x_m > reach_m + filter_m + texel_m) {
          EXPECT_NEAR(lit, 1, 2e-3) << side << ' ' << elevation_deg << ' ' << x_m;
        }
        if (x_m > filter_m && x_m < reach_m - filter_m - texel_m) {
          EXPECT_EQ(lit, 0) << side << ' ' << elevation_deg << ' ' << x_m;
        }
      }
      std::printf("side %d, %.0f degrees: shadow of %.2f mm, wanted %.2f\n", side, elevation_deg,
                  dark_m * 1000, reach_m * 1000);
      // A quarter of a texel above the floor, the shadow is shorter. At its foot the post is no nearer to the
      // light than the bias.
      EXPECT_NEAR(dark_m, reach_m, texel_m * (1 / std::tan(elevation) + 0.6) + 0.3e-3)
          << side << ' ' << elevation_deg;
    }
}

class SoftScan : public WithScan {
 protected:
  void SetUp() override {
    WithScan::SetUp();
    settings.output.width = 160, settings.output.height = 180;
    settings.quality.map_size = 1024, settings.quality.shadow_size = 1024;
    settings.output.bloom = 0;
    settings.lighting.placed_lights = {{.azimuth_deg = 70, .elevation_deg = 35}};
    settings.lighting.light_radius_m = 0.2;
  }
  RenderSettings settings;
};

image::ImageF averaged(const Scene& scene, const RenderSettings& s) {
  constexpr int times = 4;
  return downsampled(renderer().render(scene, super_sampled(s, times)), times);
}

// Nearer to the truth than the hard shadows are by far.
TEST_F(SoftScan, IsThatOfTheReference) {
  const Picture reference = render_reference(scan(), settings, {.samples = 64}).picture;
  const image::ImageF soft_light = averaged(scan(), settings);
  settings.lighting.light_radius_m = 0.0;
  const image::Image8 truth = shown(reference), soft = shown(soft_light),
                      hard = shown(averaged(scan(), settings));

  const std::vector<std::uint8_t> skin = skin_mask(reference, 0.5f);
  const double soft_db = image::psnr_db(truth, soft, skin), hard_db = image::psnr_db(truth, hard, skin);
  const double soft_flip = image::mean_flip(truth, soft, skin),
               hard_flip = image::mean_flip(truth, hard, skin);
  std::printf("against the reference: soft %.2f dB, FLIP %.4f; hard %.2f dB, %.4f\n", soft_db, soft_flip,
              hard_db, hard_flip);
  EXPECT_GE(soft_db, 38) << write_failure(linear(reference), soft_light);
  EXPECT_GE(soft_db, hard_db + 2);
  EXPECT_LT(soft_flip, 0.9 * hard_flip);
}

// The pattern of rays belongs to the light: the eye may move.
TEST_F(SoftScan, StaysWhereItIs) {
  settings = unoptimised(settings);
  settings.output.show = "irradiance";
  settings.quality.shadow_size = 512;  // less than either view needs
  const Picture one = renderer().render(scan(), settings);
  settings.camera.orbit_deg = {25, 10};
  const Picture other = renderer().render(scan(), settings);
  expect_equal_bits(one, other);
}

TEST_F(SoftScan, OptimisedIsTheSame) {
  settings = super_sampled(settings, 4);
  const Picture optimised = renderer().render(scan(), settings),
                whole = renderer().render(scan(), unoptimised(settings));
  expect_unseen(whole, optimised);
  EXPECT_EQ(optimised.statistics.unshaded_reads, 0u);
  EXPECT_EQ(optimised.statistics.transmission_misses, 0u);
}

}  // namespace
}  // namespace dermis::tests
