// SPDX-License-Identifier: MIT
#include "cli/bench/paper.h"

#include <algorithm>
#include <iterator>

namespace dermis::cli::bench {
namespace {

// [JG08] table 1, a row for each number of heads, a column for each distance.
constexpr double table_1[paper_heads.size()][paper_distances.size()] = {
    {1.17, 1.10, 1.39, 1.48, 1.53, 1.61},  //
    {1.40, 1.10, 1.46, 1.63, 1.88, 1.88},  //
    {1.66, 1.39, 1.58, 1.89, 2.10, 2.26},  //
    {1.86, 1.67, 1.95, 2.01, 2.34, 2.59},  //
    {2.01, 1.90, 2.28, 2.41, 2.50, 2.77},
};

}  // namespace

std::optional<double> paper_speedup(int heads, double distance) {
  const auto row = std::find(paper_heads.begin(), paper_heads.end(), heads);
  const auto column = std::find(paper_distances.begin(), paper_distances.end(), distance);
  if (row == paper_heads.end() || column == paper_distances.end()) return std::nullopt;
  return table_1[row - paper_heads.begin()][column - paper_distances.begin()];
}

}  // namespace dermis::cli::bench
