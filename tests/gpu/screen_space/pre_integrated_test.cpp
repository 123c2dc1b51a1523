// SPDX-License-Identifier: MIT
// Pre-integrated scattering on the shapes that its tables stand for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "plane.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/pre_integrated.h"

namespace dermis::tests {
namespace {

// White skin under one light: what faces it shows 1.
RenderSettings tabled(int width, int height) {
  RenderSettings s = small_settings("pre-integrated");
  s.output.width = width;
  s.output.height = height;
  s.output.bloom = 0;
  s.quality.samples = s.quality.light_samples = 1;
  s.quality.shadow_size = 2048;
  s.lighting.ambient = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;
  return s;
}

scene::Light facing_light(const glm::vec3& direction) {
  return directional_light(direction, glm::vec3(glm::pi<float>()));
}

std::array<double, 3> largest_difference_of(const Picture& picture, int row, int first, int last,
                                            const std::function<gaussians::Rgb(int x)>& wanted) {
  std::array<double, 3> largest{};
  for (int x = first; x < last; ++x)
    for (std::size_t c = 0; c < 3; ++c) {
      const double found = picture.linear_rgba[4 * static_cast<std::size_t>(row * picture.width + x) + c];
      largest[c] = std::max(largest[c], std::abs(found - wanted(x)[c]));
    }
  return largest;
}

// Lit from one side and seen from above: the cosine with the light grows evenly from -1 to 1. No skin shades
// itself.
TEST(PreIntegrated, IsItsTableOnASphere) {
  for (const double radius_mm : {5.0, 10.0, 20.0, 50.0})
    for (const ScreenKernel kernel : {ScreenKernel::profile, ScreenKernel::published}) {
      scene::AssetData made = scene::sphere(radius_mm / 1000, 48);
      made.lights = {facing_light({-1, 0, 0})};
      made.cameras = {camera_from_above(radius_mm / 1000, {0, 0, 0.5f})};
      RenderSettings s = tabled(101, 101);
      s.quality.kernel = kernel;
      const auto [r, g, b] =
          largest_difference_of(renderer().render(wrap(std::move(made)), s), 50, 3, 98, [&](int x) {
            const double cosine = (x + 0.5) / 50.5 - 1;
            return kernel == ScreenKernel::profile
                       ? gaussians::lit_arc(gaussians::skin_six(), cosine, 1 / radius_mm)
                       : gaussians::lit_ring(gaussians::skin_six(), cosine, 1 / radius_mm);
          });
      std::printf("%s, radius %g mm: %.4f %.4f %.4f from the table's function\n",
                  kernel == ScreenKernel::profile ? "arc" : "ring", radius_mm, r, g, b);
      EXPECT_LE(std::max({r, g, b}), 0.01);
    }
}

// A plate over a floor, whose edge throws a shadow at 45 degrees: light comes from the side of the plate.
// Half a millimetre per pixel, x = 4 to 36 mm; the shadow ends at 20.
TEST(PreIntegrated, IsTheEdgeOfTheProfileBesideAShadow) {
  struct Case {
    int taps, shadow_size;
    double most;
  };
  for (const auto& [taps, shadow_size, most] :
       {Case{16, 2048, 0.14}, {32, 2048, 0.07}, {128, 2048, 0.04}, {1024, 8192, 0.02}}) {
    scene::AssetData made =
        two_planes(0.12, 2, [](scene::Vertex& v) { v.position_m += glm::vec3(-0.06f, 0, 0.02f); });
    made.lights = {facing_light({1, 0, -1})};
    made.cameras = {camera_from_above(0.002f, {0.02f, 0, 0.3f})};
    RenderSettings s = tabled(64, 8);
    s.quality.taps = taps;
    s.quality.shadow_size = shadow_size;
    const Picture picture = renderer().render(wrap(std::move(made)), s);
    const auto [r, g, b] = largest_difference_of(picture, 4, 0, 64, [&](int x) {
      gaussians::Rgb light = gaussians::lit_edge(gaussians::skin_six(), 4 + (x + 0.5) / 2 - 20);
      for (double& value : light) value *= std::sqrt(0.5);
      return light;
    });
    std::printf("%d taps, map of %d: %.4f %.4f %.4f of the light from the edge\n", taps, shadow_size, r, g,
                b);
    EXPECT_LE(std::max({r, g, b}), most);
  }
}

// Skin that rises by 35 degrees beside a point is no occluder: light from above shows what it shows without
// scattering, on both sides of the fold.
TEST(PreIntegrated, AHollowHasNoShadow) {
  const auto rises = [](scene::Vertex& v) {
    const float along_m = v.position_m.x + 0.03f, angle = glm::radians(35.0f);
    v.position_m = {0.03f + along_m * std::cos(angle), v.position_m.y, along_m * std::sin(angle)};
    v.normal = {-std::sin(angle), 0, std::cos(angle)};
  };
  scene::AssetData made = two_planes(0.06, 2, rises);
  made.lights = {facing_light({0, 0, -1})};
  made.cameras = {camera_from_above(0.002f, {0.03f, 0, 0.3f})};
  const Scene hollow = wrap(std::move(made));
  RenderSettings s = tabled(64, 8);
  const Picture found = renderer().render(hollow, s);
  s.technique = "lambert";
  const Picture wanted = renderer().render(hollow, s);

  const auto at = [&](int x) { return 4 * static_cast<std::size_t>(4 * wanted.width + x); };
  EXPECT_GT(wanted.linear_rgba[at(2)], wanted.linear_rgba[at(61)] + 0.1f) << "both sides are in the picture";
  const auto [r, g, b] = largest_difference_of(found, 4, 0, 64, [&](int x) {
    const float* light = &wanted.linear_rgba[at(x)];
    return gaussians::Rgb{light[0], light[1], light[2]};
  });
  EXPECT_LE(std::max({r, g, b}), 0.01);
}

}  // namespace
}  // namespace dermis::tests
