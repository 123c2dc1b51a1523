// SPDX-License-Identifier: MIT
/// Memory that was freed, and that the C library keeps for its threads.
#pragma once

namespace dermis::viewer {

/// Gives back to the system what is free. Each device has threads of its own, and each thread its own heap,
/// so after ten lost devices a third of the memory was free and not given back (tests/viewer/events.sh).
/// Takes some hundredths of a second. Does nothing where the C library has no such call.
void return_free_memory();

}  // namespace dermis::viewer
