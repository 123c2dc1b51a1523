// SPDX-License-Identifier: MIT
#include "head/scene/surface/enclosure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "head/scene/framing.h"
#include "head/scene/import/shapes.h"
#include "head/scene/placement.h"
#include "scan.h"

namespace dermis::scene {
namespace {

std::vector<glm::vec3> random_points(int count, const glm::vec3& stretch, const glm::vec3& middle) {
  std::mt19937 random(11);
  std::normal_distribution<float> normal;
  std::vector<glm::vec3> points;
  for (int i = 0; i < count; ++i)
    points.push_back(middle + stretch * glm::vec3(normal(random), normal(random), normal(random)));
  return points;
}

double farthest_along(const std::vector<glm::vec3>& points, const glm::dvec3& direction) {
  double farthest = -HUGE_VAL;
  for (const glm::vec3& p : points) farthest = std::max(farthest, glm::dot(glm::dvec3(p), direction));
  return farthest;
}

std::vector<glm::dvec3> many_directions() {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<glm::dvec3> found;
  for (int i = 0; i < 500; ++i)
    found.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
  return found;
}

// In no direction do points reach beyond the corners; and corners reach beyond a ball by no more than its
// tangent planes do that touch it 23 degrees away: 1 / cos 23.
TEST(EnclosingCorners, HoldEveryPoint) {
  for (const glm::vec3& stretch : {glm::vec3(1), glm::vec3(3, 1, 0.2f), glm::vec3(1e-3f, 1, 1)}) {
    const std::vector<glm::vec3> points = random_points(800, 0.1f * stretch, {1, -2, 0.5f});
    const std::vector<glm::vec3> corners = enclosing_corners(points);
    EXPECT_LE(corners.size(), 96u);
    for (const glm::dvec3& direction : many_directions())
      EXPECT_GE(farthest_along(corners, direction), farthest_along(points, direction));
  }
}

TEST(EnclosingCorners, AreTightAroundABall) {
  const AssetData ball = sphere(0.1, 32, 0);
  const std::vector<glm::vec3> corners = enclosing_corners(ball);
  double farthest = 0, nearest = HUGE_VAL;
  for (const glm::dvec3& direction : many_directions()) {
    farthest = std::max(farthest, farthest_along(corners, direction));
    nearest = std::min(nearest, farthest_along(corners, direction));
  }
  EXPECT_GE(nearest, 0.1 * 0.999);  // the ball is one of flat triangles
  EXPECT_LE(farthest, 0.1 / std::cos(23 * 3.14159265 / 180));
}

TEST(EnclosingCorners, OfABoxAreItsCorners) {
  std::vector<glm::vec3> box;
  for (const float x : {-1.f, 1.f})
    for (const float y : {2.f, 3.f})
      for (const float z : {0.f, 0.25f}) box.emplace_back(x, y, z);
  const std::vector<glm::vec3> corners = enclosing_corners(box);
  for (const glm::vec3& p : corners)
    EXPECT_TRUE(
        std::any_of(box.begin(), box.end(), [&](const glm::vec3& q) { return glm::distance(p, q) < 1e-3f; }))
        << p.x << " " << p.y << " " << p.z;
  for (const glm::dvec3& direction : many_directions())
    EXPECT_GE(farthest_along(corners, direction), farthest_along(box, direction));
}

TEST(EnclosingCorners, OfLittle) {
  EXPECT_TRUE(enclosing_corners(std::vector<glm::vec3>{}).empty());
  const std::vector<glm::vec3> one{{1, 2, 3}};
  for (const glm::vec3& p : enclosing_corners(one)) EXPECT_EQ(p, one[0]);
  const std::vector<glm::vec3> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const glm::dvec3& direction : many_directions())
    EXPECT_GE(farthest_along(enclosing_corners(triangle), direction), farthest_along(triangle, direction));
}

// What the fit of shadow maps loses by it.
TEST(EnclosingCorners, AreTightAroundTheScan) {
  DERMIS_NEED_SCAN(scan);
  std::vector<glm::vec3> points;
  for (const Primitive& p : scan->primitives)
    for_each_position(p, [&](const glm::vec3& p_m) { points.push_back(p_m); });
  const std::vector<glm::vec3> corners = enclosing_corners(*scan);

  double sum = 0;
  for (const glm::dvec3& direction : many_directions()) {
    const double wide = farthest_along(corners, direction) + farthest_along(corners, -direction);
    const double of_points = farthest_along(points, direction) + farthest_along(points, -direction);
    EXPECT_GE(wide, of_points);
    sum += wide / of_points;
  }
  EXPECT_LE(sum / 500, 1.05);
}

}  // namespace
}  // namespace dermis::scene
