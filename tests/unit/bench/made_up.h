// SPDX-License-Identifier: MIT
// A run of the benchmark that nobody drew.
#pragma once

#include "cli/bench/result.h"

namespace dermis::tests {

/// 1 and 3 heads at 2.5 and 7 radii: the paper has one of these rows and one of these columns. The baseline
/// takes 40 ms per head, everything else less; three rounds, 1 ms apart.
cli::bench::Run made_up_run();

/// The same with pictures.
cli::bench::Run made_up_run_with_pictures();

}  // namespace dermis::tests
