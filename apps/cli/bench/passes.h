// SPDX-License-Identifier: MIT
// The passes of a frame with many heads, brought together for tables and bars.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dermis/renderer.h"

namespace dermis::cli::bench {

/// Passes that differ only in the head, the batch or the part of the skin they work on become one, with the
/// sum of their times and calls; in the order in which they first come.
std::vector<PassStatistics> merge_passes(const std::vector<PassStatistics>& passes);

/// The steps that [JG08] figure 2 tells apart, and what else a frame consists of; what is not known is the
/// last one.
const std::vector<std::string>& pass_groups();
/// The place of a pass in pass_groups().
std::size_t group_of(std::string_view pass);
/// Milliseconds of each group.
std::vector<double> group_ms(const std::vector<PassStatistics>& passes);

/// For every pass the median over frames of its time; all frames have the same passes. Empty if there are no
/// frames.
std::vector<PassStatistics> median_passes(const std::vector<std::vector<PassStatistics>>& frames);

}  // namespace dermis::cli::bench
