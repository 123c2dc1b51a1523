// SPDX-License-Identifier: MIT
// A parallel loop whose result does not depend on the number of threads: the body may write only to its own
// index.
#pragma once

#include <cstddef>
#include <functional>

namespace dermis {

/// Calls body(i) for every i in [0, count), in any order, on all cores. The first exception is rethrown after
/// all threads have ended.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace dermis
