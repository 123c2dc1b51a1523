// SPDX-License-Identifier: MIT
#include "viewer/model/camera_moves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/viewer/documents.h"

namespace dermis::viewer {
namespace {

double distance(const CameraPlace& place) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += std::pow(place.eye_m[i] - place.target_m[i], 2);
  return std::sqrt(sum);
}

void expect_near(const CameraPlace& a, const CameraPlace& b, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.eye_m[i], b.eye_m[i], tolerance) << i;
    EXPECT_NEAR(a.target_m[i], b.target_m[i], tolerance) << i;
  }
  EXPECT_NEAR(a.fov_deg, b.fov_deg, 1e-3);
}

TEST(CameraMoves, TheCameraThatFramesStandsBeforeTheHead) {
  const Document document = tests::square_document();
  const CameraPlace place = camera_place(document);
  EXPECT_NEAR(place.target_m[1], 0.5, 1e-5);
  EXPECT_NEAR(place.eye_m[1], 0.5, 1e-5);
  EXPECT_GT(place.eye_m[2], 0.3);
  EXPECT_NEAR(place.fov_deg, 20, 1e-4);
}

TEST(CameraMoves, FramingTwiceIsFramingOnce) {
  const Document document = tests::square_document();
  const double aspect = static_cast<double>(document.settings.output.width) / document.settings.output.height;
  const CameraPlace place = camera_place(document);
  expect_near(framed(place, head_sphere(document), aspect), place, 1e-5);
  const CameraPlace turned = orbited(place, 50, 20);
  expect_near(framed(turned, head_sphere(document), aspect), turned, 1e-5);
}

TEST(CameraMoves, AnOrbitKeepsTheDistanceAndComesBack) {
  const CameraPlace place{.eye_m = {0.3, 0.2, 1}, .target_m = {0, 0.1, 0}, .fov_deg = 30};
  const CameraPlace turned = orbited(place, 70, 25);
  EXPECT_NEAR(distance(turned), distance(place), 1e-12);
  expect_near(orbited(turned, -70, -25), place, 1e-12);
  // It does not turn over.
  const CameraPlace top = orbited(place, 0, 1000);
  EXPECT_LT(top.eye_m[1] - top.target_m[1], distance(place));
  expect_near(orbited(top, 0, 1000), top, 1e-9);
}

TEST(CameraMoves, APixelOfADepthIsAPointOfTheWorld) {
  Document document = tests::square_document();
  set_camera(document.settings, {.eye_m = {1, 0, 2}, .target_m = {1, 0, 0}, .fov_deg = 90});
  document.settings.output.width = 300;
  document.settings.output.height = 200;
  const io::CameraIo camera = drawn_camera(document.scene, document.settings);
  const auto expect_point = [&](double u, double v, const std::array<double, 3>& expected) {
    const std::array<double, 3> point = point_at_depth(camera, u, v, 2);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(point[i], expected[i], 1e-5) << u << " " << v << " " << i;
  };
  // 90 degrees at 2 m: the picture is 4 m high and 6 m wide.
  expect_point(0.5, 0.5, {1, 0, 0});
  expect_point(0.5, 0.25, {1, 1, 0});
  expect_point(1, 1, {4, -2, 0});
}

TEST(CameraMoves, APanMovesThePictureByPartsOfItsHeight) {
  const CameraPlace place{.eye_m = {0, 0, 2}, .target_m = {0, 0, 0}, .fov_deg = 90};
  const CameraPlace moved = panned(place, 0.25, -0.5);
  // 90 degrees at 2 m: the picture is 4 m high.
  EXPECT_NEAR(moved.eye_m[0], 1, 1e-12);
  EXPECT_NEAR(moved.target_m[0], 1, 1e-12);
  EXPECT_NEAR(moved.eye_m[1], -2, 1e-12);
}

TEST(CameraMoves, ADollyStopsBeforeTheTarget) {
  CameraPlace place{.eye_m = {0, 0, 2}, .target_m = {0, 0, 0}};
  EXPECT_NEAR(distance(dollied(place, 0.5)), 1, 1e-12);
  for (int i = 0; i < 200; ++i) place = dollied(place, 0.5);
  EXPECT_NEAR(distance(place), 1e-3, 1e-9);
  EXPECT_GT(place.eye_m[2], 0);
}

TEST(CameraMoves, FlyingGoesAlongTheAxes) {
  const CameraPlace place{.eye_m = {0, 0, 2}, .target_m = {0, 0, 0}};
  const CameraPlace moved = flown(place, {1, 2, 0.5});
  EXPECT_NEAR(moved.eye_m[0], 1, 1e-12);
  EXPECT_NEAR(moved.eye_m[1], 2, 1e-12);
  EXPECT_NEAR(moved.eye_m[2], 1.5, 1e-12);
  EXPECT_NEAR(distance(moved), 2, 1e-12);
}

TEST(CameraMoves, WhatIsSetIsWhatIsFound) {
  Document document = tests::square_document();
  document.settings.camera.orbit_deg = {40, 10};
  const CameraPlace place = camera_place(document);
  set_camera(document.settings, place);
  expect_near(camera_place(document), place, 1e-4);
  EXPECT_EQ(document.settings.camera.orbit_deg, (std::array<double, 2>{0, 0}));
  // To a micrometre, so that a command line stays short.
  const double x = document.settings.camera.eye_m->at(0) * 1e6;
  EXPECT_NEAR(x, std::round(x), 1e-6);
}

TEST(CameraMoves, TheSphereFollowsItsInstance) {
  Document document = tests::square_document();
  HeadSphereCache cache;
  EXPECT_NEAR(cache.of(document).centre_m[1], 0.5, 1e-6);
  const InstanceId head = document.scene.instances().front();
  document.scene.set_transform(head, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1});
  EXPECT_NEAR(cache.of(document).centre_m[0], 3, 1e-6);
}

}  // namespace
}  // namespace dermis::viewer
