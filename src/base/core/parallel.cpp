// SPDX-License-Identifier: MIT
#include "base/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/core/hooks.h"

namespace dermis {

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  const std::size_t threads = std::min<std::size_t>(count, std::max(1u, std::thread::hardware_concurrency()));
  const CallContext context = current_context();
  if (threads <= 1) {
    for (std::size_t i = 0; i < count; ++i) {
      stop_if_cancelled(context);
      body(i);
    }
    return;
  }

  std::atomic<std::size_t> next{0};
  std::exception_ptr first_error;
  std::mutex error_mutex;
  const auto work = [&] {
    const HookScope helping(context);
    try {
      for (std::size_t i; (i = next.fetch_add(1)) < count;) {
        stop_if_cancelled(context);
        body(i);
      }
    } catch (...) {
      const std::lock_guard lock(error_mutex);
      if (!first_error) first_error = std::current_exception();
      next = count;
    }
  };

  std::vector<std::jthread> pool;
  pool.reserve(threads);
  try {
    for (std::size_t t = 1; t < threads; ++t) pool.emplace_back(work);
  } catch (const std::system_error&) {
    // The system allows no more threads: the existing ones do all the work.
  }

  work();
  pool.clear();
  if (first_error) std::rethrow_exception(first_error);
}

}  // namespace dermis
