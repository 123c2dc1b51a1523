// SPDX-License-Identifier: MIT
#include "cli/bench/passes.h"

#include <gtest/gtest.h>

#include <numeric>

namespace dermis::cli::bench {
namespace {

TEST(Passes, OfManyHeadsBecomeOne) {
  const std::vector<PassStatistics> merged = merge_passes({{"shadow head 0", 1, 1, 64, 256},
                                                           {"shadow head 12", 2, 1, 16, 64},
                                                           {"blur 3 u batch 0", 4, 1},
                                                           {"blur 3 v batch 0", 8, 1},
                                                           {"blur 3 u batch 1 part 2", 16, 1},
                                                           {"tone map", 32, 1}});
  ASSERT_EQ(merged.size(), 4u);
  EXPECT_EQ(merged[0].name, "shadow");
  EXPECT_EQ(merged[0].ms, 3);
  EXPECT_EQ(merged[0].calls, 2);
  EXPECT_EQ(merged[0].texels, 80u);
  EXPECT_EQ(merged[0].image_bytes, 320u);
  EXPECT_EQ(merged[1].name, "blur 3 u");
  EXPECT_EQ(merged[1].ms, 20);
  EXPECT_EQ(merged[2].name, "blur 3 v");
  EXPECT_EQ(merged[3].name, "tone map");
}

TEST(Passes, HaveTheirGroups) {
  const auto group = [](const char* pass) { return pass_groups().at(group_of(pass)); };
  EXPECT_EQ(group("shadow"), "shadow maps");
  EXPECT_EQ(group("entering"), "shadow maps");
  EXPECT_EQ(group("irradiance gutters"), "irradiance");
  EXPECT_EQ(group("seen tiles batch 2"), "irradiance");
  EXPECT_EQ(group("cull triangles batch 2"), "irradiance");
  EXPECT_EQ(group("depth mask batch 1"), "masks and borders");
  EXPECT_EQ(group("blur 5 gutters"), "convolutions");
  EXPECT_EQ(group("halve 1/2"), "convolutions");
  EXPECT_EQ(group("final"), "sum and specular");
  EXPECT_EQ(group("bloom wide x"), "bloom and tone map");
  EXPECT_EQ(group("something new"), "other");
  const std::vector<double> ms =
      group_ms({{"shadow", 1, 1}, {"blur 0 u", 2, 1}, {"blur 0 v", 4, 1}, {"something new", 8, 1}});
  EXPECT_EQ(ms.size(), pass_groups().size());
  EXPECT_EQ(std::accumulate(ms.begin(), ms.end(), 0.0), 15);
  EXPECT_EQ(ms[group_of("blur 0 u")], 6);
}

TEST(Passes, MediansOverFrames) {
  const std::vector<PassStatistics> medians =
      median_passes({{{"a", 1, 2}, {"b", 30, 1}}, {{"a", 9, 2}, {"b", 10, 1}}, {{"a", 2, 2}, {"b", 20, 1}}});
  ASSERT_EQ(medians.size(), 2u);
  EXPECT_EQ(medians[0].ms, 2);
  EXPECT_EQ(medians[0].calls, 2);
  EXPECT_EQ(medians[1].ms, 20);
  EXPECT_TRUE(median_passes({}).empty());
}

}  // namespace
}  // namespace dermis::cli::bench
