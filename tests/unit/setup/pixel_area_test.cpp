// SPDX-License-Identifier: MIT
// Passes compute the pixels that may show a head, and no others: none may be missing.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "head/scene/framing.h"
#include "head/scene/surface/enclosure.h"
#include "render/setup/frame_camera.h"
#include "support/built_in.h"

namespace dermis::setup {
namespace {

constexpr glm::uvec2 size(150, 100);

struct Head {
  std::vector<glm::vec3> points_m, corners_m;
  scene::BoundingSphere sphere;
};

const Head& built_in() {
  static const Head made = [] {
    const scene::AssetData& scene = tests::built_in_head();
    Head h{.points_m = {},
           .corners_m = scene::enclosing_corners(scene),
           .sphere = scene::bounding_sphere(scene, [](const scene::Primitive&) { return true; })};
    for (const scene::Primitive& p : scene.primitives)
      for (const scene::Vertex& v : p.vertices) h.points_m.push_back(v.position_m);
    return h;
  }();
  return made;
}

// Expects every point that the picture shows to lie at least a pixel inside, or at the picture's border.
void expect_holds_all(const passes::PixelArea& area, const io::CameraIo& camera) {
  std::size_t outside = 0;
  for (const glm::vec3& p_m : built_in().points_m) {
    const glm::vec4 clip = camera.clip_from_world * glm::vec4(p_m, 1);
    if (clip.w <= 0) continue;
    const glm::vec2 at = (0.5f + 0.5f * glm::vec2(clip.x, -clip.y) / clip.w) * glm::vec2(size);
    for (int axis = 0; axis < 2; ++axis) {
      if (at[axis] < 0 || at[axis] >= static_cast<float>(size[axis])) break;  // not in the picture
      const float low = area.low[axis] == 0 ? 0 : static_cast<float>(area.low[axis]) + 1,
                  high = area.high[axis] == size[axis] ? static_cast<float>(size[axis])
                                                       : static_cast<float>(area.high[axis]) - 1;
      const int other = 1 - axis;
      const bool shown = at[other] >= 0 && at[other] < static_cast<float>(size[other]);
      outside += shown && (at[axis] < low || at[axis] > high);
    }
  }
  EXPECT_EQ(outside, 0u) << "area " << area.low.x << ", " << area.low.y << " to " << area.high.x << ", "
                         << area.high.y;
}

TEST(PixelArea, HoldsAllThatACameraSees) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const glm::dvec3 middle_m(built_in().sphere.centre_m);
  const double radius_m = built_in().sphere.radius_m;

  for (int i = 0; i < 80; ++i) {
    const double away = std::exp2(5 * std::abs(unit(random))) * radius_m * 0.4;  // also from within
    const glm::dvec3 eye_m = middle_m + away * glm::normalize(glm::dvec3(unit(random), unit(random), 2)),
                     at_m = middle_m + radius_m * glm::dvec3(unit(random), unit(random), unit(random));
    scene::Camera camera = scene::look_at_camera(eye_m, at_m, 20 + 15 * unit(random));
    if (i % 4 == 3) {
      camera.orthographic = true;
      camera.ymag_m = static_cast<float>(radius_m * std::exp2(unit(random)));
    }
    const io::CameraIo io = frame_camera(camera, 1.5);
    for (const bool corners : {true, false}) {
      const std::vector<glm::vec3> none;
      expect_holds_all(area_of({built_in().sphere, corners ? built_in().corners_m : none, nullptr}, io, size),
                       io);
    }
  }
}

TEST(PixelArea, IsSmallFarAway) {
  const glm::dvec3 middle_m(built_in().sphere.centre_m);
  const scene::Camera camera =
      scene::look_at_camera(middle_m + glm::dvec3(0, 0, 50 * built_in().sphere.radius_m), middle_m, 20);
  const passes::PixelArea area =
      area_of({built_in().sphere, built_in().corners_m, nullptr}, frame_camera(camera, 1.5), size);
  const double pixels = 2 / (2 * 50 * std::tan(glm::radians(10.0))) * size.y;  // of the diameter
  EXPECT_LE(area.size().x, pixels + 8);
  EXPECT_LE(area.size().y, pixels + 8);
  EXPECT_GT(area.size().x, 4u);
}

TEST(PixelArea, IsThePictureAroundTheEye) {
  const glm::dvec3 middle_m(built_in().sphere.centre_m);
  const scene::Camera camera = scene::look_at_camera(middle_m, middle_m + glm::dvec3(0, 0, 1), 20);
  const passes::PixelArea area =
      area_of({built_in().sphere, built_in().corners_m, nullptr}, frame_camera(camera, 1.5), size);
  EXPECT_EQ(area.low, glm::uvec2(0));
  EXPECT_EQ(area.high, size);
}

TEST(PixelArea, JoinsWhatIsThere) {
  const passes::PixelArea none, a{{2, 3}, {5, 9}}, b{{4, 1}, {7, 4}};
  for (const passes::PixelArea& one : {joined(a, none), joined(none, a)}) {
    EXPECT_EQ(one.low, a.low);
    EXPECT_EQ(one.high, a.high);
  }
  EXPECT_EQ(joined(a, b).low, glm::uvec2(2, 1));
  EXPECT_EQ(joined(a, b).high, glm::uvec2(7, 9));
  EXPECT_EQ(halved(passes::PixelArea{{3, 4}, {9, 9}}).low, glm::uvec2(1, 2));
  EXPECT_EQ(halved(passes::PixelArea{{3, 4}, {9, 9}}).high, glm::uvec2(5, 5));
}

}  // namespace
}  // namespace dermis::setup
