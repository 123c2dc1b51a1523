// SPDX-License-Identifier: MIT
/// Threads that write frames while further ones are drawn.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "cli/sequence/frames.h"

namespace dermis::cli::sequence {

/// A queue that holds as many frames as there are threads, so that memory stays bounded.
class Writers {
 public:
  /// `write` is called by any of the threads, by one alone in the order of push() if there is one thread.
  Writers(std::size_t threads, std::function<void(const Frame&)> write);
  ~Writers();  ///< waits for what was pushed
  Writers(const Writers&) = delete;
  Writers& operator=(const Writers&) = delete;

  /// Waits while the queue is full. Throws what a thread has thrown; nothing is written after that.
  void push(Frame frame);
  /// Waits until all is written. Throws likewise. No push() may follow.
  void finish();

 private:
  void work();
  void close();

  std::function<void(const Frame&)> write_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Frame> waiting_;
  bool closed_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace dermis::cli::sequence
