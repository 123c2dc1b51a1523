// SPDX-License-Identifier: MIT
// Table 1 of [JG08], held against what the paper's text says about it and against numbers read off a second
// time.
#include "cli/bench/paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace dermis::cli::bench {
namespace {

TEST(PaperTable, IsTable1) {
  // As it is printed: heads, then the speed-ups from near to far.
  std::istringstream printed(
      "1 1.17 1.10 1.39 1.48 1.53 1.61\n"
      "2 1.40 1.10 1.46 1.63 1.88 1.88\n"
      "4 1.66 1.39 1.58 1.89 2.10 2.26\n"
      "8 1.86 1.67 1.95 2.01 2.34 2.59\n"
      "16 2.01 1.90 2.28 2.41 2.50 2.77\n");

  int rows = 0;
  for (std::string line; std::getline(printed, line); ++rows) {
    std::istringstream words(line);
    int heads = 0;
    words >> heads;
    for (const double distance : {2.5, 5.0, 10.0, 20.0, 50.0, 100.0}) {
      double speedup = 0;
      words >> speedup;
      EXPECT_EQ(paper_speedup(heads, distance), speedup) << heads << " heads at " << distance;
    }
  }

  EXPECT_EQ(rows, 5);
}

// Sec. 6: "speed-up factors between 1.10 and 2.77", "greater speed-ups as the number of heads increases".
TEST(PaperTable, IsAsThePaperDescribesIt) {
  std::vector<double> all;
  for (const double distance : paper_distances) {
    double last = 0;
    for (const int heads : paper_heads) {
      const double speedup = paper_speedup(heads, distance).value();
      EXPECT_GE(speedup, last) << heads << " heads at " << distance;
      all.push_back(last = speedup);
    }
  }
  EXPECT_EQ(*std::min_element(all.begin(), all.end()), 1.10);
  EXPECT_EQ(*std::max_element(all.begin(), all.end()), 2.77);
}

TEST(PaperTable, HasNoOtherCells) {
  for (const int heads : {0, 3, 5, 32, -1}) EXPECT_FALSE(paper_speedup(heads, 5).has_value()) << heads;
  for (const double distance : {0.0, 2.4, 7.0, 99.0, 1000.0})
    EXPECT_FALSE(paper_speedup(4, distance).has_value()) << distance;
}

}  // namespace
}  // namespace dermis::cli::bench
