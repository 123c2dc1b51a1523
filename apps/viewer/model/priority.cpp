// SPDX-License-Identifier: MIT
#include "viewer/model/priority.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace dermis::viewer {

void take_priority(Priority priority) {
#ifdef __linux__
  // On Linux 0 is the calling thread, not its process. Ten steps leave it a tenth of a busy processor.
  constexpr int steps = 10;
  if (priority == Priority::background) setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps);
#else
  static_cast<void>(priority);
#endif
}

}  // namespace dermis::viewer
