// SPDX-License-Identifier: MIT
// Cameras by look-at and by a host's matrices, whatever its conventions, show what ours show.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "alone.h"
#include "dermis/error.h"
#include "head/scene/framing.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "render/setup/camera_matrices.h"
#include "render/setup/frame_camera.h"
#include "support/thrown.h"
#include "truth/reference/camera_ray.h"

namespace dermis::setup {
namespace {

constexpr double aspect = 1.5, near_m = 0.05, far_m = 40;
constexpr double width = 96, height = 64;

std::array<double, 16> values_of(const glm::dmat4& matrix) {
  std::array<double, 16> values{};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      values[static_cast<std::size_t>(4 * column + row)] = matrix[column][row];
  return values;
}

scene::Camera plain_camera() { return scene::look_at_camera({0.3, 0.2, 0.9}, {0.02, -0.05, 0.01}, 30); }

// The same camera with a lens of its own: x and y of the clip volume as given, depth as the convention has
// it.
struct Lens {
  double left = -0.3, right = 0.5, bottom = -0.2, top = 0.35;  // at distance 1, or metres if orthographic
  bool orthographic = false;
};

struct Convention {
  std::string name;
  bool reversed = false, infinite = false, y_down = false, along_z = false;
  double scale = 1;  // of the whole matrix
};

CameraMatrices matrices_of(const scene::Camera& camera, const Lens& lens, const Convention& c) {
  glm::dmat4 clip(0);
  clip[0][0] = 2 / (lens.right - lens.left);
  clip[1][1] = 2 / (lens.top - lens.bottom);
  const glm::dvec2 middle((lens.right + lens.left) / (lens.right - lens.left),
                          (lens.top + lens.bottom) / (lens.top - lens.bottom));
  if (lens.orthographic) {
    clip[3] = glm::dvec4(-middle, 0, 1);
    clip[2][2] = (c.reversed ? 1 : -1) / (far_m - near_m);
    clip[3][2] = (c.reversed ? far_m : -near_m) / (far_m - near_m);
  } else {
    clip[2] = glm::dvec4(middle, 0, -1);
    if (c.reversed) {
      clip[2][2] = c.infinite ? 0 : near_m / (far_m - near_m);
      clip[3][2] = c.infinite ? near_m : near_m * far_m / (far_m - near_m);
    } else {
      clip[2][2] = c.infinite ? -1 : -far_m / (far_m - near_m);
      clip[3][2] = c.infinite ? -near_m : -near_m * far_m / (far_m - near_m);
    }
  }

  glm::dmat4 view = glm::inverse(glm::dmat4(camera.world_from_camera));
  if (c.y_down)
    for (int column = 0; column < 4; ++column) clip[column][1] = -clip[column][1];
  if (c.along_z) {
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1), glm::dvec3(1, 1, -1));
    view = mirror * view;
    clip = clip * mirror;
  }
  return {values_of(view), values_of(clip * c.scale)};
}

const Convention conventions[] = {
    {.name = "Vulkan, y down", .y_down = true},
    {.name = "Vulkan, negative viewport"},
    {.name = "reversed, infinite", .reversed = true, .infinite = true},
    {.name = "reversed, infinite, y down", .reversed = true, .infinite = true, .y_down = true},
    {.name = "reversed, finite", .reversed = true},
    {.name = "forward, infinite", .infinite = true},
    {.name = "left-handed", .along_z = true},
    {.name = "left-handed, reversed", .reversed = true, .along_z = true},
    {.name = "scaled", .reversed = true, .scale = 7}};

glm::dvec2 on_picture(const io::CameraIo& camera, const glm::dvec3& position_m) {
  const glm::vec4 clip = camera.clip_from_world * glm::vec4(position_m, 1);
  return glm::dvec2(clip) / double{clip.w};
}

TEST(LookAt, TheTargetIsInTheMiddleAndUpIsUp) {
  const scene::Camera camera = plain_camera();
  const io::CameraIo seen = frame_camera(camera, aspect);
  EXPECT_NEAR(glm::length(on_picture(seen, {0.02, -0.05, 0.01})), 0, 1e-5);
  EXPECT_NEAR(glm::distance(seen.eye_m, glm::vec3(0.3f, 0.2f, 0.9f)), 0, 1e-6);
  const glm::dvec2 above = on_picture(seen, {0.02, 0.05, 0.01});
  EXPECT_NEAR(above.x, 0, 1e-5);
  EXPECT_GT(above.y, 0.1);
}

TEST(LookAt, StraightDownHasAnUpToo) {
  const io::CameraIo seen = frame_camera(scene::look_at_camera({0, 2, 0}, {0, 0, 0}), aspect);
  EXPECT_GT(on_picture(seen, {0, 0, -0.1}).y, 0.1) << "the upper border is towards -z";
  EXPECT_GT(on_picture(seen, {0.1, 0, 0}).x, 0.1);
  EXPECT_THROW(scene::look_at_camera({1, 1, 1}, {1, 1, 1}), InputError);
  EXPECT_THROW(scene::look_at_camera({1, 1, std::nan("")}, {1, 1, 1}), InputError);
}

TEST(Matrices, ShowTheSameInEveryConvention) {
  const scene::Camera native = plain_camera();
  for (const bool orthographic : {false, true})
    for (const Convention& convention : conventions) {
      if (orthographic && convention.infinite) continue;
      SCOPED_TRACE(convention.name + (orthographic ? ", orthographic" : ""));
      const Lens lens{.orthographic = orthographic};
      const CameraMatrices matrices = matrices_of(native, lens, convention);
      const scene::Camera camera = camera_of(matrices);
      const io::CameraIo seen = frame_camera(camera, aspect);
      const glm::mat4 exact = picture_from_world(matrices, camera),
                      of_host = glm::mat4(upright_clip_from_world(matrices));
      for (const int row : {0, 1, 3}) EXPECT_EQ(glm::row(exact, row), glm::row(of_host, row));
      EXPECT_NEAR(camera.znear_m, near_m, 1e-5);
      EXPECT_EQ(camera.orthographic, orthographic);
      EXPECT_NEAR(glm::distance(seen.eye_m, glm::vec3(0.3f, 0.2f, 0.9f)), 0, 1e-6);

      // A point that a ray through each corner of the lens meets 2 m ahead is in that corner.
      for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 1.0}) {
          const double depth_m = 2, side = orthographic ? 1 : depth_m;
          const glm::dvec4 of_camera(side * (lens.left + x * (lens.right - lens.left)),
                                     side * (lens.bottom + y * (lens.top - lens.bottom)), -depth_m, 1);
          const glm::dvec3 position_m(glm::dmat4(native.world_from_camera) * of_camera);
          EXPECT_NEAR(glm::distance(on_picture(seen, position_m), glm::dvec2(2 * x - 1, 2 * y - 1)), 0, 1e-5);
          const glm::vec4 clip = exact * glm::vec4(position_m, 1),
                          rounded = seen.clip_from_world * glm::vec4(position_m, 1);
          EXPECT_NEAR(glm::distance(clip / clip.w, rounded / rounded.w), 0, 1e-5) << "depth too";

          // The ray of the reference through that corner meets the point too.
          reference::RenderSetup setup;
          setup.camera = camera;
          setup.width = static_cast<int>(width), setup.height = static_cast<int>(height);
          const rays::Ray ray = reference::camera_ray(setup, x * width, (1 - y) * height);
          const glm::dvec3 to = position_m - glm::dvec3(ray.origin_m);
          EXPECT_NEAR(glm::length(glm::cross(to, glm::dvec3(ray.direction))), 0, 1e-5);
        }
    }
}

TEST(Matrices, WhatIsNoCameraIsRefused) {
  const CameraMatrices good = matrices_of(plain_camera(), {}, {});
  const auto refused = [&](const std::function<void(CameraMatrices&)>& change) {
    CameraMatrices bad = good;
    change(bad);
    return tests::thrown<InputError>([&] { camera_of(bad); });
  };
  const auto expect = [](const std::string& said, const std::string& part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  const std::string view = "camera.matrices.camera_from_world", clip = "camera.matrices.clip_from_camera";

  EXPECT_EQ(refused([](CameraMatrices&) {}), "nothing was thrown");
  for (const double number : {std::nan(""), HUGE_VAL, -1e30}) {
    expect(refused([&](CameraMatrices& m) { m.camera_from_world[13] = number; }), view);
    expect(refused([&](CameraMatrices& m) { m.clip_from_camera[10] = number; }), clip);
  }
  expect(refused([](CameraMatrices& m) { m = {}; }), "row of w");
  expect(refused([](CameraMatrices& m) { m.camera_from_world = {}; }), "rigid");
  expect(refused([](CameraMatrices& m) { m.camera_from_world[0] *= 2; }), "rigid");
  expect(refused([](CameraMatrices& m) { m.camera_from_world[3] = 1; }), "last row");
  expect(refused([](CameraMatrices& m) {
           for (const int i : {2, 6, 10, 14}) m.camera_from_world[static_cast<std::size_t>(i)] *= -1;
         }),
         "reflection");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[0] *= -1; }), "growing to the right");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[1] = 1; }), "sheared");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[2] = 1; }), "oblique");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[10] = -m.clip_from_camera[10]; }), "near plane");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[15] = 3; }), "row of w");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[0] = 1e-300; }), "must");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[5] = 1e-300; }), "must");
  expect(refused([](CameraMatrices& m) { m.clip_from_camera[14] = -1e-50; }), "near plane");

  // Along +z, in a right-handed camera space.
  expect(refused([](CameraMatrices& m) {
           for (const std::size_t i : {8u, 9u, 10u, 11u}) m.clip_from_camera[i] *= -1;
         }),
         "determinant -1");
}

TEST(Matrices, AnOrthographicCameraSeesWhatLiesBeforeIt) {
  const Lens lens{.orthographic = true};
  CameraMatrices behind = matrices_of(plain_camera(), lens, {.along_z = true});
  EXPECT_NO_THROW(camera_of(behind));
  // The projection of one that looks along +z, and a view that looks along -z.
  behind.camera_from_world = matrices_of(plain_camera(), lens, {}).camera_from_world;
  EXPECT_THROW(camera_of(behind), InputError);
}

TEST(Scenes, WithNothingToSeeAreRefused) {
  scene::AssetData point = scene::sphere(0.1);
  point.name = "point.glb";
  for (scene::Vertex& vertex : point.primitives.front().vertices) vertex.position_m = glm::vec3(1, 2, 3);
  PlacedScene scene;
  scene.instances.push_back(placed(scene::measured(scene::sphere(0.1))));
  EXPECT_NO_THROW(check_seen(scene));
  scene.instances.push_back(placed(scene::measured(point)));
  EXPECT_EQ(tests::thrown<InputError>([&] { check_seen(scene); }),
            "point.glb: has nothing to see: all its triangles lie at one point");
}

// Where the camera stands around a head and how far from it are settings of their own.
TEST(ChosenCamera, OrbitsAtItsDistance) {
  const std::shared_ptr<const scene::AssetData> ball = scene::measured(scene::sphere(0.1));
  RenderSettings s;
  const auto eye_m = [&] { return glm::dvec3(set_up_alone(ball, s).frame.camera.eye_m); };
  s.camera.orbit_deg = {70, 20};
  const glm::dvec3 framed_m = eye_m();
  s.camera.distance = 6;
  const glm::dvec3 from_six_radii_m = eye_m();
  EXPECT_NEAR(glm::length(from_six_radii_m), 6 * ball->bounds.sphere.radius_m, 1e-6);
  EXPECT_NEAR(glm::distance(glm::normalize(from_six_radii_m), glm::normalize(framed_m)), 0, 1e-6);
  s.camera.orbit_deg = {0, 0};
  EXPECT_NEAR(glm::distance(eye_m(), glm::dvec3(0, 0, glm::length(from_six_radii_m))), 0, 1e-6);
}

}  // namespace
}  // namespace dermis::setup
