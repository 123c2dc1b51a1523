// SPDX-License-Identifier: MIT
// dermis info: which devices there are, and what is missing on those that cannot be used.
#pragma once

namespace dermis::cli {

/// Prints to stdout, as text or as one JSON object {"devices": [...]}. Returns the exit status: 1, with one line on stderr, if no device is
/// usable.
int run_info(bool json);

}  // namespace dermis::cli
