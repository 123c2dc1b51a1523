// SPDX-License-Identifier: MIT
// Where vertices stand, and where the camera of a picture shows them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../gltf/support.h"
#include "api/asset_state.h"
#include "api/scene_state.h"
#include "dermis/camera.h"
#include "dermis/scene.h"
#include "head/scene/import/shapes.h"
#include "head/scene/placement.h"
#include "head/scene/surface/measured.h"
#include "render/setup/choose.h"
#include "render/setup/frame_camera.h"
#include "support/built_in.h"
#include "support/thrown.h"

namespace dermis::scene::test {
namespace {

// Turned by 90 degrees about +Y, of half the size, moved.
constexpr std::array<double, 16> turned{0, 0, -0.5, 0, 0, 0.5, 0, 0, 0.5, 0, 0, 0, 0.1, 0.2, -0.3, 1};

glm::dvec2 projected(const ResolvedCamera& camera, const std::array<double, 3>& x) {
  glm::dvec3 c;
  for (int row = 0; row < 3; ++row) {
    const auto at = static_cast<std::size_t>(3 * row);
    c[row] = camera.r[at] * x[0] + camera.r[at + 1] * x[1] + camera.r[at + 2] * x[2] +
             camera.t_m[static_cast<std::size_t>(row)];
  }
  if (!camera.orthographic) c /= c.z;
  return {camera.k[0] * c.x + camera.k[2], camera.k[4] * c.y + camera.k[5]};
}

TEST(Positions, OfAPosedInstanceAreThoseOfItsPicture) {
  const Asset head = Asset::State::make(measured(dermis::tests::built_in_head()));
  ASSERT_FALSE(head.morph_weights().empty());
  dermis::Scene scene;
  const InstanceId id = scene.add({.asset = head, .world_from_asset = turned});
  const std::vector<std::uint32_t> some{0, 17, 17, 400, 4000};
  const auto rest = scene.positions_m(id, 0, some);
  RigPose pose;
  for (const std::string& name : head.morph_weights()) pose.weights.push_back({name, 0.5});
  scene.set_pose(id, pose);

  // As the reference takes the scene, vertex by vertex.
  const auto flat = setup::flattened(api::placed_scene(scene));
  const Primitive& skin = flat->primitives.front();
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < skin.vertices.size(); ++v) vertices.push_back(source_vertex(skin, v));
  ASSERT_GT(vertices.size(), 4000u);
  const auto found = scene.positions_m(id, 0, vertices);
  for (std::uint32_t v = 0; v < skin.vertices.size(); ++v)
    for (glm::length_t i = 0; i < 3; ++i)
      ASSERT_NEAR(found[v][static_cast<std::size_t>(i)], skin.vertices[v].position_m[i], 1e-6) << v;

  double moved_m = 0;
  const auto posed = scene.positions_m(id, 0, vertices);
  scene.set_pose(id, {});
  const auto loaded = scene.positions_m(id, 0, vertices);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) moved_m = std::max(moved_m, std::abs(posed[v][i] - loaded[v][i]));
  EXPECT_GT(moved_m, 1e-3) << "the pose moves something";
  EXPECT_EQ(scene.positions_m(id, 0, some), rest);
  EXPECT_EQ(rest[1], rest[2]);
}

TEST(Positions, WhatIsNotThereIsRefused) {
  dermis::Scene scene;
  const InstanceId id = scene.add({.asset = Asset::State::make(measured(plane(0.2)))});
  const std::uint32_t first[] = {0}, beyond[] = {123456};
  EXPECT_EQ(scene.positions_m(id, 0, {}).size(), 0u);
  EXPECT_EQ(scene.positions_m(id, 0, first).size(), 1u);
  EXPECT_NE(tests::thrown<InputError>([&] { scene.positions_m(id, 0, beyond); }).find("no vertex 123456"),
            std::string::npos);
  EXPECT_NE(tests::thrown<InputError>([&] { scene.positions_m(id, 7, first); }).find("no mesh 7"),
            std::string::npos);
  EXPECT_NE(
      tests::thrown<InputError>([&] { scene.positions_m(InstanceId{99}, 0, first); }).find("instance 99"),
      std::string::npos);
}

// The camera as shaders have it, which shows clip -1 to 1 on the whole of the picture.
void expect_as_drawn(const dermis::Scene& scene, const RenderSettings& settings) {
  const setup::PlacedScene placed = api::placed_scene(scene);
  const Camera camera = setup::choose_camera(placed, settings, setup::head_spheres(placed, settings));
  const double width = settings.output.width, height = settings.output.height;
  const io::CameraIo drawn = setup::frame_camera(camera, width / height);
  const ResolvedCamera resolved = resolved_camera(scene, settings);
  EXPECT_EQ(resolved.width, settings.output.width);
  EXPECT_EQ(resolved.height, settings.output.height);

  for (const std::array<double, 3> x :
       {std::array{0.0, 0.0, 0.0}, {0.05, -0.03, 0.02}, {-0.04, 0.06, -0.05}}) {
    const glm::dvec4 clip = glm::dmat4(drawn.clip_from_world) * glm::dvec4(x[0], x[1], x[2], 1);
    const glm::dvec2 wanted((clip.x / clip.w + 1) / 2 * width - 0.5,
                            (1 - clip.y / clip.w) / 2 * height - 0.5);
    const glm::dvec2 found = projected(resolved, x);
    EXPECT_NEAR(found.x, wanted.x, 1e-3);
    EXPECT_NEAR(found.y, wanted.y, 1e-3);
  }
  const auto& r = resolved.r;
  const double determinant = r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) +
                             r[2] * (r[3] * r[7] - r[4] * r[6]);
  EXPECT_NEAR(determinant, 1, 1e-6) << "a rotation, not a mirror";
}

TEST(ResolvedCamera, ProjectsAsThePictureIsDrawn) {
  dermis::Scene scene;
  scene.add({.asset = Asset::State::make(measured(sphere(0.1)))});
  RenderSettings s{.output = {.width = 120, .height = 80}};
  expect_as_drawn(scene, s);
  s.camera.orbit_deg = {30, -10};
  s.camera.fov_deg = 45;
  expect_as_drawn(scene, s);
  s.camera = {.eye_m = {{0.3, 0.2, 0.6}}, .target_m = {{0.01, 0, 0.02}}};
  expect_as_drawn(scene, s);

  // Off the axis, and without perspective.
  CameraMatrices m{.camera_from_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -0.02, -0.01, -0.5, 1},
                   .clip_from_camera = {4, 0, 0, 0, 0, 6, 0, 0, 0.3, -0.2, -1.0101, -1, 0, 0, -0.10101, 0}};
  s.camera = {.matrices = m};
  expect_as_drawn(scene, s);
  m.clip_from_camera = {5, 0, 0, 0, 0, 7, 0, 0, 0, 0, -0.1, 0, 0.1, -0.3, -0.01, 1};
  s.camera = {.matrices = m};
  EXPECT_TRUE(resolved_camera(scene, s).orthographic);
  expect_as_drawn(scene, s);
}

TEST(ResolvedCamera, IsThatOfOpenCv) {
  dermis::Scene scene;
  scene.add({.asset = Asset::State::make(measured(sphere(0.1)))});
  const RenderSettings s{.camera = {.fov_deg = 90, .eye_m = {{0, 0, 2}}, .target_m = {{0, 0, 0}}},
                         .output = {.width = 100, .height = 50}};
  const ResolvedCamera camera = resolved_camera(scene, s);
  EXPECT_NEAR(camera.k[0], 25, 1e-5) << "half the height over the tangent of half the angle";
  EXPECT_NEAR(camera.k[4], 25, 1e-5);
  EXPECT_NEAR(camera.k[2], 49.5, 1e-9) << "the middle of the first pixel is 0";
  EXPECT_NEAR(camera.k[5], 24.5, 1e-9);
  EXPECT_NEAR(camera.t_m[2], 2, 1e-6) << "+z ahead";
  EXPECT_GT(projected(camera, {0.1, 0, 0}).x, 49.5) << "+x to the right";
  EXPECT_LT(projected(camera, {0, 0.1, 0}).y, 24.5) << "our +y is up";
}

}  // namespace
}  // namespace dermis::scene::test
