// SPDX-License-Identifier: MIT
// Results of the benchmark that were written as JSON, and what has changed from one run to another.
#pragma once

#include <string>
#include <vector>

#include "cli/bench/statistics.h"
#include "dermis/renderer.h"

namespace dermis::cli::bench {

struct RecordedTimes {
  std::string variant;
  std::vector<double> rounds_ms;
  std::vector<PassStatistics> passes;
};

struct RecordedCell {
  int heads = 1;
  double distance = 0;
  std::vector<RecordedTimes> times;
};

struct Recorded {
  std::string file, commit, device, scene;
  std::vector<std::pair<std::string, std::string>> settings;  ///< by path, "quality.map_size"; values as JSON
  std::vector<RecordedCell> cells;
};

/// InputError names the file and the place in it: no JSON, no result of the benchmark, times that are none.
Recorded read_recorded(const std::string& path);

/// One variant of one cell in both runs.
struct TimeChange {
  int heads = 1;
  double distance = 0;
  std::string variant;
  double before_ms = 0, after_ms = 0;  ///< medians
  Comparison found;
  std::string pass;    ///< whose median has changed most in the direction of the frame; empty: not known
  double pass_ms = 0;  ///< by so much
};

struct RunComparison {
  Recorded before, after;
  std::vector<TimeChange> changes;  ///< slower or faster, the greatest gap first
  std::size_t compared = 0;         ///< times in both
  std::size_t slower = 0, faster = 0;
  /// number of each that is to be expected if nothing has changed
  double by_chance = 0;
  std::size_t only_before = 0, only_after = 0;  ///< times that the other run has not
};

/// InputError: other settings or another scene, so that times say nothing; nothing in common.
RunComparison compare_runs(Recorded before, Recorded after);

std::string comparison_text(const RunComparison& comparison);
std::string comparison_json(const RunComparison& comparison);

}  // namespace dermis::cli::bench
