// SPDX-License-Identifier: MIT
// What the alpha test cuts away is in no ray's way, gets no light and is not seen.
#include <gtest/gtest.h>

#include "head/scene/import/shapes.h"
#include "rays/alpha_test.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

constexpr double size_m = 0.02;

/// A plane of which the left half is there: alpha 1, 1, 0, 0, and 0.5 in the middle between.
scene::AssetData half_plane() {
  scene::AssetData made = scene::plane(size_m);
  const image::Image8 pixels{.width = 4,
                             .height = 1,
                             .rgba = {255, 255, 255, 255, 255, 255, 255, 255,  //
                                      255, 255, 255, 0, 255, 255, 255, 0}};
  made.images.push_back({.name = "mask", .pixels = std::make_shared<const image::Image8>(pixels)});
  scene::Material& skin = made.materials.front();
  skin.alpha_mode = AssetAlpha::mask;
  skin.base_colour_map.image = 0;
  skin.base_colour_map.wrap_u = skin.base_colour_map.wrap_v = AssetWrap::clamp;
  return made;
}

TEST(CutOut, IsInNoRaysWay) {
  const scene::AssetData scene = half_plane();
  const rays::RayScene rays(scene);
  for (const double x : {-0.0095, -0.004, -0.0002, 0.0002, 0.004, 0.0095}) {
    const rays::Ray down{.origin_m = {x, 0.001, 0.01}, .direction = {0, 0, -1}};
    EXPECT_EQ(rays.solid_between(down), x < 0) << x;
    EXPECT_EQ(rays.nearest_solid(down).has_value(), x < 0) << x;
    EXPECT_TRUE(rays.nearest(down)) << "of all triangles, as they are";
    EXPECT_EQ(rays::is_cut_away(scene, rays::surface_point(scene, *rays.nearest(down))), x > 0) << x;
  }
}

// The nearer of an opaque sheet and a cut-out one counts, in either order.
TEST(CutOut, StandsAmongOpaqueThings) {
  scene::AssetData scene = half_plane();
  scene::Primitive floor = scene.primitives.front();
  scene.materials.push_back({.name = "floor"});
  floor.material = 1;
  for (scene::Vertex& v : floor.vertices) v.position_m.z = -0.005f;
  scene.primitives.push_back(floor);
  const rays::RayScene rays(scene);
  for (const double x : {-0.004, 0.004})
    for (const double side : {1.0, -1.0}) {
      const auto hit = rays.nearest_solid({.origin_m = {x, 0.001, side * 0.01}, .direction = {0, 0, -side}});
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->primitive, x < 0 && side > 0 ? 0u : 1u);
    }
}

TEST(CutOut, IsNotSeenAndGetsNoLight) {
  const scene::AssetData scene = half_plane();
  Job job = tests::furnace(scene, 16);
  job.setup.camera = tests::camera_from_above(size_m / 2, {0, 0, 0.01f});
  const Tracer tracer(scene, job);
  const image::ImageF picture = tests::rendered(tracer, 4).picture();
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) EXPECT_EQ(picture.at(x, y)[3], x < 8 ? 1.0f : 0.0f) << x << " " << y;

  Random random = random_of(1, 0, 0);
  for (const double x : {-0.004, 0.004}) {
    const auto hit = tracer.shading().rays().nearest({.origin_m = {x, 0.001, 0.01}, .direction = {0, 0, -1}});
    const glm::dvec3 light = tracer.shading().light_in_skin(rays::surface_point(scene, *hit), random);
    EXPECT_EQ(light.x > 0.9, x < 0) << x;
    EXPECT_EQ(light.x == 0, x > 0) << x;
  }
}

}  // namespace
}  // namespace dermis::reference
