// SPDX-License-Identifier: MIT
// A run of the benchmark as a page.
#pragma once

#include <string>

#include "cli/bench/result.h"

namespace dermis::cli::bench {

/// Speed-ups next to the paper's as table and curves, frames, and for every cell its pictures under a slider,
/// its passes as bars and its texels; what is lit of a head. One file that asks nothing of the network.
/// Pictures where the run kept them.
std::string run_page(const Run& run);

}  // namespace dermis::cli::bench
