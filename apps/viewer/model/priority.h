// SPDX-License-Identifier: MIT
/// Who waits where there are more threads than processors.
#pragma once

namespace dermis::viewer {

enum class Priority {
  hand,        ///< what a hand on a slider waits for
  background,  ///< what may take longer when something else is to be done
};

/// Gives the calling thread, and the threads that it starts from now on, their priority. A system that knows
/// none for threads changes nothing.
void take_priority(Priority priority);

}  // namespace dermis::viewer
