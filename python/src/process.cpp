// SPDX-License-Identifier: MIT
#include "process.h"

#include <unistd.h>

#include <stdexcept>

namespace dermis::python {
namespace {
pid_t process = 0;
}  // namespace

void remember_process() { process = getpid(); }
bool is_our_process() { return getpid() == process; }

void check_process() {
  if (!is_our_process())
    throw std::runtime_error(
        "dermis was imported before this process was forked, and what it holds does not work here; start "
        "workers by 'spawn' (multiprocessing.get_context(\"spawn\"))");
}

}  // namespace dermis::python
