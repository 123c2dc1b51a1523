// SPDX-License-Identifier: MIT
#include "work.h"

#include <nanobind/nanobind.h>

#include <chrono>
#include <exception>
#include <stdexcept>
#include <thread>
#include <vector>

#include "process.h"

namespace nb = nanobind;

namespace dermis::python {
namespace {

using namespace std::chrono_literals;
constexpr auto between_looks = 50ms;  // at signals
constexpr auto patience = 500ms;      // until what was stopped has ended

/// Task of a thread, and its result.
struct Task {
  std::function<void()> work;
  std::exception_ptr thrown;
  bool done = false;
  std::mutex mutex;
  std::condition_variable finished;

  void run() {
    std::exception_ptr what;
    try {
      work();
    } catch (...) { what = std::current_exception(); }
    const std::lock_guard lock(mutex);
    thrown = what;
    done = true;
    finished.notify_all();
  }
  bool wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex);
    return finished.wait_for(lock, most, [this] { return done; });
  }
};

/// Threads that wait for tasks; as many as have ever worked at a time.
class Threads {
 public:
  void give(std::shared_ptr<Task> task) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(task));
    if (idle_ < waiting_.size()) threads_.emplace_back([this] { serve(); });
    wake_.notify_one();
  }

  void end() {
    std::vector<std::thread> threads;
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
      threads = std::exchange(threads_, {});
      wake_.notify_all();
    }
    for (std::thread& thread : threads) thread.join();
  }

 private:
  void serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
      ++idle_;
      wake_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      --idle_;
      if (waiting_.empty()) return;
      std::shared_ptr<Task> task = std::move(waiting_.back());
      waiting_.pop_back();
      lock.unlock();
      task->run();
      task.reset();
      lock.lock();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<std::shared_ptr<Task>> waiting_;
  std::vector<std::thread> threads_;
  std::size_t idle_ = 0;
  bool ending_ = false;
};

// Never destroyed: a process that was forked has none of its threads.
Threads& threads() {
  static auto* const made = new Threads;
  return *made;
}

// True: the desk is the caller's.
bool try_to_take(Desk& desk) {
  const std::lock_guard lock(desk.mutex);
  if (desk.busy && !desk.left_behind)
    throw std::runtime_error(
        "this renderer, or a session of it, works in another thread; each thread takes a renderer of its "
        "own");
  if (desk.busy) return false;
  desk.busy = true;
  desk.left_behind = false;
  desk.stop = false;
  return true;
}

// Nobody waits for the GIL while holding the mutex: who has the one may want the other.
void take(Desk& desk) {
  while (!try_to_take(desk)) {
    {
      const nb::gil_scoped_release released;
      std::unique_lock lock(desk.mutex);
      desk.freed.wait_for(lock, between_looks, [&] { return !desk.busy; });
    }
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
  }
}

void leave(Desk& desk) {
  const std::lock_guard lock(desk.mutex);
  desk.busy = false;
  desk.freed.notify_all();
}

struct Leaving {
  Desk& desk;
  ~Leaving() { leave(desk); }
};

}  // namespace

void run_at(const std::shared_ptr<Desk>& desk, std::function<void()> work) {
  check_process();
  take(*desk);
  const auto task = std::make_shared<Task>();
  task->work = [desk, work = std::move(work)]() mutable {
    const Leaving leaving{*desk};
    const std::function<void()> mine = std::move(work);  // gone before the desk is free
    mine();
  };

  {
    const nb::gil_scoped_release released;
    threads().give(task);
    while (!task->wait(between_looks)) {
      const nb::gil_scoped_acquire acquired;
      if (PyErr_CheckSignals() == 0) continue;
      nb::python_error raised;
      desk->stop = true;
      {
        const nb::gil_scoped_release again;
        if (!task->wait(patience)) {
          const std::lock_guard lock(desk->mutex);
          desk->left_behind = true;
        }
      }
      throw raised;
    }
  }
  if (task->thrown) std::rethrow_exception(task->thrown);
}

void run_here(const std::shared_ptr<Desk>& desk, const std::function<void()>& work) {
  check_process();
  take(*desk);
  const Leaving leaving{*desk};
  const nb::gil_scoped_release released;
  work();
}

void end_threads() {
  if (!is_our_process()) return;
  const nb::gil_scoped_release released;
  threads().end();
}

}  // namespace dermis::python
