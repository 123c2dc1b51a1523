// SPDX-License-Identifier: MIT
// Harmonics turned as the device does it, in doubles, against their values at directions turned back.
#include "render/shared/turned_harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "environment/harmonics.h"
#include "environment/texel_grid.h"
#include "head/scene/import/shapes.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;

// As many directions as terms, and more, in no plane of symmetry.
std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> made;
  for (int i = 0; i < 60; ++i) {
    const double y = 1 - (2 * i + 1.0) / 60, azimuth = i * pi * (3 - std::sqrt(5.0));
    made.emplace_back(std::sqrt(1 - y * y) * std::cos(azimuth), y, std::sqrt(1 - y * y) * std::sin(azimuth));
  }
  return made;
}

double sum_at(const Harmonics& terms, const glm::dvec3& d) {
  const Harmonics y = harmonics(d);
  double sum = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) sum += terms[k] * y[k];
  return sum;
}

Harmonics some_terms() {
  Harmonics terms{};
  for (std::size_t k = 0; k < terms.size(); ++k) terms[k] = std::sin(1.7 * static_cast<double>(k) + 0.3);
  return terms;
}

// Returns how far the turned series is from the series at directions turned back.
double error_of(const glm::dquat& q) {
  const Harmonics before = some_terms();
  Harmonics after = before;
  io::turn_harmonics(after, glm::dvec4(q.x, q.y, q.z, q.w));
  double worst = 0;
  for (const glm::dvec3& d : directions())
    worst = std::max(worst, std::abs(sum_at(after, d) - sum_at(before, glm::conjugate(q) * d)));
  return worst;
}

TEST(TurnedHarmonics, AreThoseOfDirectionsTurnedBack) {
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 axis =
        glm::normalize(glm::dvec3(std::sin(3.1 * i), std::cos(1.9 * i), std::sin(0.7 * i)));
    EXPECT_LE(error_of(glm::angleAxis(0.37 * i - 7, axis)), 1e-12) << i;
  }
}

// Where an angle of the three is free, and near there.
TEST(TurnedHarmonics, AreSoAboutTheAxesAndByNothing) {
  for (const double angle : {0.0, 1e-9, 1e-5, 0.5, pi / 2, pi - 1e-6, pi, 1.5 * pi, 2 * pi})
    for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                   glm::normalize(glm::dvec3(1e-7, 1, 1e-7))}) {
      const glm::dquat q = glm::angleAxis(angle, axis);
      EXPECT_LE(error_of(q), 1e-12) << angle << " about " << axis.x << " " << axis.y << " " << axis.z;
      EXPECT_LE(error_of(-q), 1e-12) << "the same rotation";
    }
}

// The table of the quarter turn is that of tools/quarter_turn.py: +Y becomes +Z.
TEST(TurnedHarmonics, QuarterTurnTakesUpToTheFront) {
  const Harmonics before = some_terms();
  Harmonics after = before;
  io::quarter_turn_about_x(after);
  for (const glm::dvec3& d : directions())
    EXPECT_NEAR(sum_at(after, d), sum_at(before, {d.x, d.z, -d.y}), 1e-13);
}

// Each texel that the bake fills from its neighbours has a point of the mesh, no further than the rings are.
TEST(TexelGrid, IsDilatedByThePointsOfNeighbours) {
  const scene::AssetData scene = scene::plane(0.05, glm::dmat2(0.5), {0.25, 0.25}, 4);
  const std::vector<scene::SkinMesh> meshes = scene::skin_meshes(scene);
  const TexelGrid grid = rasterise(meshes.front(), 64), wide = dilated(grid);
  int covered = 0, added = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const GridTexel &before = grid.texels[grid.at(x, y)], &after = wide.texels[wide.at(x, y)];
      const int off = std::max({16 - x, x - 47, 16 - y, y - 47, 0});
      EXPECT_EQ(before.covered(), off == 0) << x << " " << y;
      EXPECT_EQ(after.covered(), off <= dilation) << x << " " << y;
      covered += before.covered() ? 1 : 0;
      added += after.covered() && !before.covered() ? 1 : 0;
      if (!after.covered()) continue;

      const std::uint32_t* index = &meshes.front().indices[3 * std::size_t{after.triangle}];
      const glm::vec2 at = meshes.front().unwrap[index[0]] * (1 - after.u - after.v) +
                           meshes.front().unwrap[index[1]] * after.u +
                           meshes.front().unwrap[index[2]] * after.v;
      const glm::vec2 nearest = glm::clamp(glm::vec2(x, y), glm::vec2(16), glm::vec2(47)) + 0.5f;
      EXPECT_LE(glm::distance(at * 64.0f, nearest), 1e-3f + static_cast<float>(off)) << x << " " << y;
    }
  EXPECT_EQ(covered, 32 * 32);
  EXPECT_EQ(added, 44 * 44 - 32 * 32);
}

}  // namespace
}  // namespace dermis::environment
