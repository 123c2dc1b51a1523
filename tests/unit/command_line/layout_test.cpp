// SPDX-License-Identifier: MIT
// Where several heads stand.
#include "cli/layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dermis::cli {
namespace {

using Places = std::vector<std::array<double, 2>>;

void expect_near(const Places& places, const Places& expected) {
  ASSERT_EQ(places.size(), expected.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(places[i][axis], expected[i][axis], 1e-12) << i << (axis == 0 ? " right" : " up");
}

TEST(Layouts, ARowGivesTheLargerNeighbourItsRoom) {
  expect_near(places_m(Layout::row, {1, 1, 1}), {{-1.6, 0}, {0, 0}, {1.6, 0}});
  expect_near(places_m(Layout::row, {1, 3, 2, 1}), {{-9.6, 0}, {-4.8, 0}, {0, 0}, {3.2, 0}});
  expect_near(places_m(Layout::row, {1}), {{0, 0}});
  EXPECT_TRUE(places_m(Layout::row, {}).empty());
}

TEST(Layouts, AGridIsNearlySquareAndBeginsAtItsTop) {
  expect_near(places_m(Layout::grid, {1, 1, 1, 1, 1}),
              {{-3.2, 0}, {-1.6, 0}, {0, 0}, {-3.2, -2}, {-1.6, -2}});
  expect_near(places_m(Layout::grid, {1, 1, 3, 1}), {{0, 6}, {1.6 * 3, 6}, {0, 0}, {1.6 * 3, 0}});
  for (const std::size_t count : {2u, 4u, 7u, 16u, 17u}) {
    const Places places = places_m(Layout::grid, std::vector<double>(count, 1));
    std::size_t in_first_row = 0;
    for (const auto& place : places) in_first_row += place[1] == places[0][1] ? 1 : 0;
    EXPECT_EQ(in_first_row, static_cast<std::size_t>(std::ceil(std::sqrt(count)))) << count;
  }
}

}  // namespace
}  // namespace dermis::cli
