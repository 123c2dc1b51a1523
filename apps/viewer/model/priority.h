// SPDX-License-Identifier: MIT
/// Priority of threads where there are more of them than processors.
#pragma once

namespace dermis::viewer {

enum class Priority {
  hand,        ///< a hand on a slider waits for it
  background,  ///< it may take longer when something else is to be done
};

/// Gives the calling thread, and the threads that it starts from now on, their priority. A system that knows
/// none for threads changes nothing.
void take_priority(Priority priority);

}  // namespace dermis::viewer
