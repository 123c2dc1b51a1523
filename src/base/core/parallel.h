// SPDX-License-Identifier: MIT
// A parallel loop whose result does not depend on the number of threads: the body may write only to its own
// index.
#pragma once

#include <cstddef>
#include <functional>

namespace dermis {

/// Calls body(i) for every i in [0, count), in any order, on all cores, with the hooks of the calling thread
/// (base/core/hooks.h). The first exception is rethrown after all threads have ended. Throws Cancelled if the
/// caller of the library ends the work.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace dermis
