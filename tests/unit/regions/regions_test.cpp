// SPDX-License-Identifier: MIT
// Regions of pictures whose answer is known, and of the built-in head, whose landmarks are.
#include "truth/regions/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "head/scene/framing.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "head/scene/surface/unwrap.h"
#include "support/built_in.h"
#include "truth/reference/camera_ray.h"
#include "truth/regions/head_frame.h"
#include "truth/regions/parts.h"
#include "unit/reference/scenes.h"

namespace dermis::regions {
namespace {

reference::RenderSetup framed(const scene::AssetData& scene, int side, double azimuth_deg = 0) {
  reference::RenderSetup setup;
  setup.camera = scene::framing_camera(scene::skin_bounds(scene).sphere, 1, azimuth_deg, 0);
  setup.width = setup.height = side;
  return setup;
}

scene::Light from(const glm::dvec3& towards) { return tests::directional_light(glm::vec3(-towards)); }

const Region& named(const std::vector<Region>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Region& r) { return r.name == name; });
  EXPECT_NE(found, all.end()) << name;
  return *found;
}

/// Calls visit(point that pixel i shows, i) for each pixel of skin.
template <class Visit>
void for_each_point(const rays::RayScene& rays, const reference::RenderSetup& setup, const Visit& visit) {
  for (int y = 0; y < setup.height; ++y)
    for (int x = 0; x < setup.width; ++x) {
      const auto hit = rays.nearest_skin(reference::camera_ray(setup, x + 0.5, y + 0.5));
      if (hit) visit(rays::surface_point(rays.scene(), *hit), static_cast<std::size_t>(y * setup.width + x));
    }
}

TEST(Regions, ABallHasATerminatorAndNeitherNoseNorEars) {
  const scene::AssetData ball = *scene::measured(scene::sphere(0.1, 64));
  const rays::RayScene rays(ball);
  reference::RenderSetup setup = framed(ball, 96);
  setup.lights = {from({1, 0, 0})};
  const std::vector<Region> all = find(rays, setup);
  for (const char* empty : {"ears", "nose", "shadow edges", "thin parts", "folds"})
    EXPECT_EQ(named(all, empty).pixels, 0u) << empty;
  EXPECT_GT(named(all, "skin").pixels, 5000u);
  const Region& terminator = named(all, "terminator");
  for_each_point(rays, setup, [&](const rays::SurfacePoint& p, std::size_t i) {
    const double cosine = p.position_m.x / 0.1;
    // On the dark side only as far as 12 mm from light.
    if (cosine > -0.11 && cosine < 0.19) { EXPECT_TRUE(terminator.mask[i]) << cosine; }
    if (std::abs(cosine) > 0.21) { EXPECT_FALSE(terminator.mask[i]) << cosine; }
  });
  setup.lights.front().colour = glm::vec3(0);
  EXPECT_EQ(named(find(rays, setup), "terminator").pixels, 0u) << "a lamp that is off";
}

TEST(Regions, SeamsAreWhereTheUnwrapIsCut) {
  // Six charts, cut where two coordinates are equal.
  const scene::AssetData ball = *scene::measured(scene::sphere(0.1, 32));
  const rays::RayScene rays(ball);
  const reference::RenderSetup setup = framed(ball, 128);
  const std::vector<Region> all = find(rays, setup);
  const Region &seams = named(all, "seams"), &rest = named(all, "the rest");
  EXPECT_GT(seams.pixels, 100u);
  for_each_point(rays, setup, [&](const rays::SurfacePoint& p, std::size_t i) {
    const glm::dvec3 a = glm::abs(p.position_m);
    // from the nearest cut that is seen
    const double off_mm = 1000 * std::abs(a.z - std::max(a.x, a.y)) / std::sqrt(2.0);
    if (off_mm < 1) { EXPECT_TRUE(seams.mask[i]) << off_mm; }
    if (off_mm > 7 && std::abs(a.x - a.y) > 0.01) { EXPECT_FALSE(seams.mask[i]) << off_mm; }
    EXPECT_NE(seams.mask[i] != 0, rest.mask[i] != 0) << "without lights there is nothing else";
  });
}

// A sheet over half of a plane: the shadow ends at x = 0.
TEST(Regions, ShadowEdgesReachFiveMillimetres) {
  scene::AssetData scene = scene::plane(0.12);
  tests::add_sheet(scene, 0.2f, 0.05f);
  scene = *scene::measured(scene);

  const rays::RayScene rays(scene);
  reference::RenderSetup setup;
  setup.camera = tests::camera_from_above(0.02, {0, 0, 0.02f});  // between skin and sheet
  setup.width = setup.height = 80;                               // half a millimetre each
  setup.lights = {from({0, 0, 1})};

  const std::vector<Region> all = find(rays, setup);
  EXPECT_EQ(named(all, "terminator").pixels, 0u);
  for (std::size_t x = 0; x < 80; ++x) {
    const double mm = (static_cast<double>(x) + 0.5) / 2 - 20;
    if (std::abs(mm) < 4.5) { EXPECT_TRUE(named(all, "shadow edges").mask[40 * 80 + x]) << mm; }
    if (std::abs(mm) > 6) { EXPECT_FALSE(named(all, "shadow edges").mask[40 * 80 + x]) << mm; }
  }
}

TEST(Regions, ThicknessOfABox) {
  for (const double depth_mm : {3.0, 12.0}) {
    const scene::AssetData box = *scene::measured(tests::box(depth_mm, 100));
    const rays::RayScene rays(box);
    const auto hit = rays.nearest_skin({.origin_m = {0.001, 0.002, 1}, .direction = {0, 0, -1}});
    ASSERT_TRUE(hit);
    // Half of a cone of 60 degrees lies within acos(3/4) of its axis.
    EXPECT_NEAR(1000 * thickness_m(rays, rays::surface_point(box, *hit)), depth_mm / 0.75, 0.05 * depth_mm);
  }
  reference::RenderSetup setup;
  setup.camera = tests::camera_from_above(0.05, {0, 0, 0.5f});
  setup.width = setup.height = 16;
  EXPECT_EQ(named(find(rays::RayScene(*scene::measured(tests::box(5, 100))), setup), "thin parts").pixels,
            256u);
  EXPECT_EQ(named(find(rays::RayScene(*scene::measured(tests::box(50, 100))), setup), "thin parts").pixels,
            0u);
}

// Two boxes side by side with a slit of 2 mm between them: a fold is where one sees the other.
TEST(Regions, ASlitIsAFold) {
  scene::AssetData scene = tests::box(20, 10);
  scene::Primitive other = scene.primitives.front();
  for (scene::Vertex& v : other.vertices) v.position_m.x += 0.022f;
  scene.primitives.push_back(other);
  const rays::RayScene rays(scene);
  const auto inside = rays.nearest_skin({.origin_m = {0.011, 0.001, -0.01}, .direction = {-1, 0, 0}});
  const auto top = rays.nearest_skin({.origin_m = {0.001, 0.002, 1}, .direction = {0, 0, -1}});
  ASSERT_TRUE(inside && top);
  EXPECT_NEAR(1000 * gap_m(rays, rays::surface_point(scene, *inside)), 2.3, 0.2);
  EXPECT_GT(gap_m(rays, rays::surface_point(scene, *top)), 1);
  EXPECT_EQ(
      named(find(rays::RayScene(*scene::measured(tests::box(50, 100))), framed(tests::box(50, 100), 16)),
            "folds")
          .pixels,
      0u);
}

TEST(Regions, OfTheBuiltInHead) {
  const scene::AssetData head = *scene::measured(tests::built_in_head());
  const rays::RayScene rays(head);

  const std::optional<HeadFrame> frame = HeadFrame::find(rays);
  ASSERT_TRUE(frame);
  EXPECT_NEAR(1000 * frame->half_breadth_m(), 85, 15);
  EXPECT_NEAR(frame->nose_tip_m().x, 0, 0.002);

  const reference::RenderSetup front = framed(head, 160);
  const std::vector<Region> all = find(rays, front);
  std::array<int, 2> ears{};  // right, left
  double nose_mm = 0;
  for_each_point(rays, front, [&](const rays::SurfacePoint& p, std::size_t i) {
    const glm::dvec3 from_tip_mm = 1000.0 * (p.position_m - frame->nose_tip_m());
    if (named(all, "ears").mask[i]) {
      ++ears[from_tip_mm.x > 0];
      EXPECT_GT(std::abs(from_tip_mm.x), 50);
      EXPECT_LT(from_tip_mm.z, -55);
    }
    if (named(all, "nose").mask[i]) nose_mm = std::max(nose_mm, glm::length(from_tip_mm));
    if (glm::length(from_tip_mm) < 8) { EXPECT_TRUE(named(all, "nose").mask[i]); }
  });

  EXPECT_GT(ears[0], 40);
  EXPECT_NEAR(ears[0], ears[1], 0.3 * ears[0]) << "the head is symmetric";
  EXPECT_GT(nose_mm, 30);
  EXPECT_LT(nose_mm, 60);

  // From behind there is no nose, but both ears.
  const std::vector<Region> behind = find(rays, framed(head, 160, 180));
  EXPECT_EQ(named(behind, "nose").pixels, 0u);
  EXPECT_GT(named(behind, "ears").pixels, 40u);
}

TEST(Parts, OfTheBuiltInHeadsVertices) {
  const scene::AssetData& head = tests::built_in_head();
  const rays::RayScene rays(head);
  const std::optional<HeadFrame> frame = HeadFrame::find(rays);
  ASSERT_TRUE(frame);
  const std::vector<scene::SkinMesh> skin = scene::skin_meshes(head);
  const auto parts = parts_of_skin(head, skin);
  ASSERT_EQ(parts.size(), skin.size());

  std::array<int, 3> count{};  // nose, right ear, left ear
  for (std::size_t i = 0; i < skin.size(); ++i) {
    ASSERT_EQ(parts[i].size(), skin[i].vertices.size());
    for (std::size_t v = 0; v < parts[i].size(); ++v) {
      const glm::dvec3 p(skin[i].vertices[v].position_m);
      EXPECT_EQ(parts[i][v].x > 0, frame->on_nose(p));
      if (parts[i][v].y > 0) { EXPECT_TRUE(frame->beside_the_head(p)); }
      count[0] += parts[i][v].x > 0;
      count[p.x > 0 ? 2 : 1] += parts[i][v].y > 0;
    }
  }
  EXPECT_GT(count[0], 100);
  EXPECT_GT(count[1], 100);
  EXPECT_NEAR(count[1], count[2], 0.1 * count[1]) << "the head is symmetric";

  const scene::AssetData ball = scene::sphere(0.1);
  const auto of_ball = parts_of_skin(ball, scene::skin_meshes(ball));
  for (const glm::vec2& part : of_ball.front()) EXPECT_EQ(part, glm::vec2(-1));
}

// A triangle of an ear, grown about its middle until its corners lie farther from it than an ear's skin is
// closed.
TEST(Parts, OfLargeTriangles) {
  const scene::AssetData& head = tests::built_in_head();
  const rays::RayScene rays(head);
  const std::optional<HeadFrame> frame = HeadFrame::find(rays);
  ASSERT_TRUE(frame);
  scene::SkinMesh mesh = scene::skin_meshes(head).front();

  int tried = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size() && tried < 10; t += 30) {
    std::array<glm::dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.vertices[mesh.indices[t + k]].position_m;
    rays::SurfacePoint middle;
    middle.position_m = (corners[0] + corners[1] + corners[2]) / 3.0;
    middle.face_normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    if (frame->inside_sides(middle.position_m) < 0.25) continue;
    if (thickness_m(rays, middle) > 0.9 * frame->ear_thickness_m()) continue;

    scene::SkinMesh large;
    const double shortest_m =
        std::min({glm::distance(corners[0], middle.position_m), glm::distance(corners[1], middle.position_m),
                  glm::distance(corners[2], middle.position_m)});
    const double growth = 1.2 * frame->ear_closing_m() / shortest_m;
    for (const glm::dvec3& corner : corners)
      large.vertices.push_back(
          {.position_m = glm::vec3(middle.position_m + growth * (corner - middle.position_m))});
    large.indices = {0, 1, 2};
    if (std::any_of(large.vertices.begin(), large.vertices.end(), [&](const scene::Vertex& v) {
          return !frame->beside_the_head(glm::dvec3(v.position_m));
        }))
      continue;
    ++tried;
    const auto of_large = parts_of_skin(head, std::span(&large, 1));
    for (const glm::vec2& part : of_large.front()) EXPECT_GT(part.y, 0);
  }
  EXPECT_GT(tried, 0);
}

}  // namespace
}  // namespace dermis::regions
