// SPDX-License-Identifier: MIT
// Boxes of masks that are drawn by hand.
#include "tools/dataset/boxes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dermis::dataset {
namespace {

image::Image8 mask(const std::vector<std::string>& rows) {
  image::Image8 made{
      .width = static_cast<int>(rows[0].size()), .height = static_cast<int>(rows.size()), .rgba = {}};
  for (const std::string& row : rows)
    for (const char c : row)
      made.rgba16.insert(made.rgba16.end(), 4, static_cast<std::uint16_t>(c == '.' ? 0 : c - '0'));
  return made;
}

TEST(Boxes, AreAroundAllPixelsOfAValue) {
  const image::Image8 m = mask({"......", ".12...", "..1...", "....3."});
  EXPECT_EQ(box_of(m, 1), (Box{1, 1, 2, 2, 2}));
  EXPECT_EQ(box_of(m, 0), (Box{1, 1, 4, 3, 4})) << "of all that is there";
  EXPECT_EQ(box_of(m, 7), Box{});
}

TEST(Boxes, PartsTouchBySides) {
  const image::Image8 m = mask({"22..2", "2..22", "..2.2", "2...."});
  EXPECT_EQ(boxes_of_parts(m, 2, 1),
            (std::vector<Box>{{0, 0, 2, 2, 3}, {3, 0, 2, 3, 4}, {2, 2, 1, 1, 1}, {0, 3, 1, 1, 1}}));
  EXPECT_EQ(boxes_of_parts(m, 2, 4), (std::vector<Box>{{3, 0, 2, 3, 4}}));
  EXPECT_TRUE(boxes_of_parts(m, 1, 1).empty());
}

TEST(Boxes, ALargePartTakesNoStack) {
  const std::vector<std::string> rows(1000, std::string(1000, '1'));
  EXPECT_EQ(boxes_of_parts(mask(rows), 1, 1), (std::vector<Box>{{0, 0, 1000, 1000, 1'000'000}}));
}

}  // namespace
}  // namespace dermis::dataset
