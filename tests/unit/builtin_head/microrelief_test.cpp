// SPDX-License-Identifier: MIT
// The tile of relief below a texel of the maps: no seam where it repeats, level, and of unit normals.
#include "head/builtin_head/microrelief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace dermis::builtin_head {
namespace {

// Mean step of both slopes from a column (or row) to the next.
double mean_step(const image::Image8& tile, int column, bool rows) {
  const auto at = [&](int along, int i, int channel) {
    const int x = rows ? i : along % tile.width, y = rows ? along % tile.height : i;
    return int{tile.rgba[static_cast<std::size_t>(4 * (y * tile.width + x) + channel)]};
  };
  double sum = 0;
  for (int i = 0; i < tile.width; ++i)
    for (int channel : {0, 1}) sum += std::abs(at(column + 1, i, channel) - at(column, i, channel));
  return sum / tile.width;
}

TEST(Microrelief, RepeatsWithoutASeam) {
  const image::Image8 tile = microrelief(256);
  for (const bool rows : {false, true}) {
    double largest = 0;
    for (int column = 0; column + 1 < tile.width; ++column)
      largest = std::max(largest, mean_step(tile, column, rows));
    EXPECT_GT(largest, 1);
    EXPECT_LE(mean_step(tile, tile.width - 1, rows), largest);
  }
}

TEST(Microrelief, IsLevelAndOfUnitNormals) {
  const image::Image8 tile = microrelief(256);
  glm::dvec3 sum(0);
  double steepest = 0;
  for (std::size_t i = 0; i < tile.rgba.size(); i += 4) {
    const glm::dvec3 n = glm::dvec3(tile.rgba[i], tile.rgba[i + 1], tile.rgba[i + 2]) / 127.5 - 1.0;
    EXPECT_NEAR(glm::length(n), 1, 0.02);
    sum += n;
    steepest = std::max(steepest, std::hypot(n.x, n.y) / n.z);
  }
  sum /= static_cast<double>(tile.rgba.size() / 4);
  EXPECT_NEAR(sum.x, 0, 0.01);
  EXPECT_NEAR(sum.y, 0, 0.01);
  EXPECT_GT(steepest, 0.2);
  EXPECT_LT(steepest, 2);
}

}  // namespace
}  // namespace dermis::builtin_head
