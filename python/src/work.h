// SPDX-License-Identifier: MIT
// Runs C++ in a thread of its own, so that the calling thread, which has released the GIL, answers signals:
// Ctrl-C ends long work within a second. Work that does not end by then is left behind: whoever uses the same
// renderer next waits for it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>

namespace dermis::python {

/// One thread at a time may use this: a renderer with its sessions, or one call.
struct Desk {
  std::atomic<bool> stop = false;  ///< ends what works: dermis::Hooks::stop
  std::mutex mutex;
  std::condition_variable freed;
  bool busy = false;
  bool left_behind = false;  ///< its caller has gone
};

/// Runs `work` while the calling thread waits, without the GIL. Rethrows what it throws. Throws
/// std::runtime_error if another thread uses the desk, nb::python_error if a signal handler raises
/// (KeyboardInterrupt). `work` may outlive the call: it owns all that it uses, the desk too.
void run_at(const std::shared_ptr<Desk>& desk, std::function<void()> work);

/// Likewise, and returns what `work` returns.
template <class Work>
auto run(const std::shared_ptr<Desk>& desk, Work work) {
  using Result = std::invoke_result_t<Work>;
  if constexpr (std::is_void_v<Result>) {
    run_at(desk, std::move(work));
  } else {
    const auto result = std::make_shared<std::optional<Result>>();
    run_at(desk, [result, work = std::move(work)]() mutable { result->emplace(work()); });
    return std::move(**result);
  }
}

/// Runs short work in the calling thread, without the GIL: a thread of its own costs a tenth of a
/// millisecond. Signals wait until it has ended. Throws as run_at() does.
void run_here(const std::shared_ptr<Desk>& desk, const std::function<void()>& work);

/// Of work that no renderer does.
template <class Work>
auto run(Work work) {
  return run(std::make_shared<Desk>(), std::move(work));
}

/// Waits for what was left behind, and ends the threads; at the end of the interpreter.
void end_threads();

}  // namespace dermis::python
