// SPDX-License-Identifier: MIT
// Landmarks follow poses, and a depth picture decides which of them are seen.
#include "dermis/landmarks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "api/asset_state.h"
#include "dermis/error.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/assets.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

// Turned by 90 degrees about +Y, of half the size, moved.
constexpr std::array<double, 16> turned{0, 0, -0.5, 0, 0, 0.5, 0, 0, 0.5, 0, 0, 0, 0.1, 0.2, -0.3, 1};

const Asset& head() {
  static const Asset made = Asset::built_in();
  return made;
}

glm::dvec3 vec(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

std::vector<glm::dvec3> at_rest(const Asset& asset) {
  const Scene scene(asset);
  std::vector<glm::dvec3> points;
  for (const auto& p : Landmarks::of(asset).value().positions_m(scene, scene.instances().front()))
    points.push_back(vec(p));
  return points;
}

// What holds of the points of every face that looks along +Z, in metres.
void expect_a_face(const std::vector<glm::dvec3>& p, bool open_eyes = true) {
  ASSERT_EQ(p.size(), Landmarks::count);
  const auto expect_rising = [&](std::initializer_list<std::size_t> numbers, glm::length_t axis) {
    for (auto i = numbers.begin(); i + 1 != numbers.end(); ++i)
      EXPECT_LT(p[*i][axis], p[*(i + 1)][axis]) << *i << " before " << *(i + 1);
  };
  // From the person's right, -X, to the left.
  expect_rising({0, 3, 5, 6, 7, 8, 9, 10, 11, 13, 16}, 0);
  expect_rising({17, 18, 19, 20, 21, 27, 22, 23, 24, 25, 26}, 0);
  expect_rising({36, 37, 68, 38, 39, 27, 42, 43, 69, 44, 45}, 0);
  expect_rising({36, 41, 40, 39, 42, 47, 46, 45}, 0);
  expect_rising({31, 32, 33, 34, 35}, 0);
  expect_rising({48, 49, 50, 51, 52, 53, 54}, 0);
  expect_rising({48, 59, 58, 57, 56, 55, 54}, 0);
  expect_rising({60, 61, 62, 63, 64}, 0);
  expect_rising({60, 67, 66, 65, 64}, 0);
  // From below.
  expect_rising({8, 57, 66, 62, 51, 33, 30, 29, 28, 27}, 1);
  expect_rising({41, 37, 18}, 1);
  expect_rising({47, 43, 24}, 1);
  expect_rising({40, 38}, 1);
  expect_rising({46, 44}, 1);
  for (std::size_t i = 0; i < p.size(); ++i)
    EXPECT_LE(p[i].z, p[30].z) << "the tip of the nose is foremost, before " << i;

  const auto expect_between = [&](std::size_t a, std::size_t b, double least_m, double most_m) {
    EXPECT_GE(glm::distance(p[a], p[b]), least_m) << a << " to " << b;
    EXPECT_LE(glm::distance(p[a], p[b]), most_m) << a << " to " << b;
  };
  // Of women and men.
  expect_between(68, 69, 0.054, 0.069);
  expect_between(36, 45, 0.074, 0.098);
  expect_between(48, 54, 0.040, 0.057);
  expect_between(0, 16, 0.125, 0.160);
  if (open_eyes) expect_between(37, 41, 0.004, 0.014);
}

TEST(Landmarks, OfTheBuiltInHeadAreThoseOfAFace) {
  expect_a_face(at_rest(head()));
  EXPECT_EQ(Landmarks::of(Asset::load("built-in:dark")).value().places()[30].vertices,
            Landmarks::of(head()).value().places()[30].vertices);
}

TEST(Landmarks, OfHeadsOfOthersAreThoseOfAFace) {
  const auto folder = asset_cache();
  const std::vector<std::filesystem::path> files{
      folder / "ict-facekit/ict-mean-animated.glb",
      folder / "makehuman/mh-african-man-young.glb",
      folder / "makehuman/mh-asian-woman-young.glb",
      folder / "makehuman/mh-european-man-young.glb",
      folder / "makehuman/mh-african-man-young-sub1.glb",
      folder / "makehuman/crowd/mh-crowd-african-man-old-lod0.glb",
      folder / "makehuman/crowd/mh-crowd-european-woman-young-lod0.glb"};
  if (const std::string missing = missing_asset(files); !missing.empty()) GTEST_SKIP() << missing;
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename());
    expect_a_face(at_rest(Asset::load(file)));
  }
}

TEST(Landmarks, OfTheScanAreThoseOfAFace) {
  if (const std::string missing = missing_scan(); !missing.empty()) GTEST_SKIP() << missing;
  expect_a_face(at_rest(Asset::load(scan_manifest())), false);
}

TEST(Landmarks, StandWhereTheirTrianglesStand) {
  Scene scene;
  const InstanceId id = scene.add({.asset = head(), .world_from_asset = turned});
  RigPose pose;
  for (const std::string& name : head().morph_weights()) pose.weights.push_back({name, 0.3});
  scene.set_pose(id, pose);
  const Landmarks marks = Landmarks::of(head()).value();
  const auto found = marks.positions_m(scene, id);
  ASSERT_EQ(found.size(), Landmarks::count);

  for (std::size_t i = 0; i < Landmarks::count; ++i) {
    const LandmarkPlace& place = marks.places()[i];
    const auto corners = scene.positions_m(id, place.mesh, place.vertices);
    glm::dvec3 mean(0);
    for (std::size_t k = 0; k < 3; ++k) mean += place.weights[k] * vec(corners[k]);
    EXPECT_LT(glm::distance(mean, vec(found[i])), 1e-9) << i;
  }
}

TEST(Landmarks, OfTheLipsPartAndThoseOfTheLidsMeet) {
  Scene scene(head());
  const InstanceId id = scene.instances().front();
  const Landmarks marks = Landmarks::of(head()).value();
  const auto gap_m = [&](std::size_t a, std::size_t b) {
    const auto p = marks.positions_m(scene, id);
    return p[a][1] - p[b][1];
  };
  const double closed_m = gap_m(62, 66), open_m = gap_m(38, 40);
  scene.set_pose(id, RigPose{.weights = {{"jaw open", 1}, {"blink right", 1}}});
  EXPECT_GT(gap_m(62, 66), closed_m + 0.005);
  EXPECT_LT(gap_m(38, 40), open_m - 0.004) << "points 36 to 41 are the person's right eye";
  EXPECT_GT(gap_m(43, 47), 0.004) << "and the left one stays open";
}

/// Looks along -Z from z = 1 m; a pixel of the plane z = 0 is 10 mm wide.
ResolvedCamera camera(double near_m = 0.01) {
  return {.width = 60,
          .height = 60,
          .near_m = near_m,
          .k = {100, 0, 29.5, 0, 100, 29.5, 0, 0, 1},
          .r = {1, 0, 0, 0, -1, 0, 0, 0, -1},
          .t_m = {0, 0, 1}};
}

struct Shown {
  Scene scene;
  InstanceId id{};
  std::vector<Landmark> points(const std::vector<float>& depth_m, double near_m = 0.01) const {
    return Landmarks::of(head()).value().in_picture(scene, id, camera(near_m), depth_m);
  }
  std::size_t seen(const std::vector<float>& depth_m) const {
    std::size_t count = 0;
    for (const Landmark& mark : points(depth_m)) count += mark.seen ? 1 : 0;
    return count;
  }
};
Shown shown() {
  Shown made;
  made.id = made.scene.add({.asset = head()});
  return made;
}

constexpr float nothing = std::numeric_limits<float>::infinity();

TEST(Landmarks, AreProjectedAsTheCameraSays) {
  const Shown s = shown();
  const std::vector<float> empty(3600, nothing);
  for (const Landmark& mark : s.points(empty)) {
    const double z = 1 - mark.position_m[2];
    EXPECT_NEAR(mark.depth_m, z, 1e-12);
    EXPECT_NEAR(mark.x, 29.5 + 100 * mark.position_m[0] / z, 1e-9);
    EXPECT_NEAR(mark.y, 29.5 - 100 * mark.position_m[1] / z, 1e-9);
    EXPECT_FALSE(mark.seen);
  }
  for (const Landmark& mark : s.points(empty, 2)) EXPECT_TRUE(std::isnan(mark.x)) << "before the near plane";
}

TEST(Landmarks, AreSeenWhereTheDepthIsTheirs) {
  const Shown s = shown();
  const Landmark tip = s.points(std::vector<float>(3600, nothing))[30];
  const auto pixel = [&](double right, double down) {
    return static_cast<std::size_t>(60 * std::floor(tip.y + down) + std::floor(tip.x + right));
  };
  const auto with = [&](double behind_m, double right_m, double left_m) {
    std::vector<float> depth(3600, nothing);
    depth[pixel(0, 0)] = static_cast<float>(tip.depth_m + behind_m);
    depth[pixel(1, 0)] = depth[pixel(2, 0)] = static_cast<float>(tip.depth_m + behind_m + right_m);
    depth[pixel(-1, 0)] = static_cast<float>(tip.depth_m + behind_m + left_m);
    return s.points(depth)[30].seen;
  };
  EXPECT_TRUE(with(0, 0, 0));
  EXPECT_TRUE(with(0.0009, 0, 0)) << "within 1 mm";
  EXPECT_FALSE(with(0.0011, 0, 0));
  EXPECT_FALSE(with(-0.0011, 0, 0)) << "something stands before it";
  EXPECT_TRUE(with(-0.0049, -0.005, 0.005)) << "a slope of 5 mm per pixel";
  EXPECT_FALSE(with(-0.006, -0.005, 0.005));
  EXPECT_FALSE(with(-0.004, 0.5, 0.0001)) << "an edge on one side is no slope";

  // Any of the four pixels around it, and no other.
  const auto alone = [&](double right, double down) {
    std::vector<float> depth(3600, nothing);
    depth[pixel(right, down)] = static_cast<float>(tip.depth_m);
    return s.points(depth)[30].seen;
  };
  for (const double right : {-1, 0, 1, 2})
    for (const double down : {-1, 0, 1, 2})
      EXPECT_EQ(alone(right, down), (right == 0 || right == 1) && (down == 0 || down == 1));
}

TEST(Landmarks, OfAHiddenInstanceAreNotSeen) {
  Shown s = shown();
  const auto points = s.points(std::vector<float>(3600, nothing));
  std::vector<float> depth(3600, static_cast<float>(points[30].depth_m));
  EXPECT_TRUE(s.points(depth)[30].seen);
  s.scene.set_visible(s.id, false);
  EXPECT_EQ(s.seen(depth), 0u);
}

TEST(Landmarks, WhatIsNotTheirsIsRefused) {
  const Landmarks marks = Landmarks::of(head()).value();
  Scene scene;
  const InstanceId id = scene.add({.asset = Asset::State::make(scene::measured(scene::plane(0.2)))});
  EXPECT_NE(thrown<InputError>([&] { marks.positions_m(scene, id); }).find("of another asset"),
            std::string::npos);
  EXPECT_NE(thrown<InputError>([&] { marks.positions_m(scene, InstanceId{99}); }).find("instance 99"),
            std::string::npos);
  const Shown s = shown();
  EXPECT_NE(thrown<InputError>([&] { s.points(std::vector<float>(12)); }).find("12 pixels"),
            std::string::npos);
}

}  // namespace
}  // namespace dermis::tests
