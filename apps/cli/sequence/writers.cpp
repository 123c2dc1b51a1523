// SPDX-License-Identifier: MIT
#include "cli/sequence/writers.h"

#include <utility>

namespace dermis::cli::sequence {

Writers::Writers(std::size_t threads, std::function<void(const Frame&)> write) : write_(std::move(write)) {
  threads_.reserve(threads);
  try {
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
  } catch (...) {
    close();
    throw;
  }
}

Writers::~Writers() { close(); }

void Writers::push(Frame frame) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || waiting_.size() < threads_.size(); });
  if (failure_) std::rethrow_exception(failure_);
  waiting_.push_back(std::move(frame));
  changed_.notify_all();
}

void Writers::finish() {
  close();
  if (failure_) std::rethrow_exception(failure_);
}

void Writers::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void Writers::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return closed_ || failure_ || !waiting_.empty(); });
    if (failure_ || waiting_.empty()) return;
    const Frame frame = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();

    lock.unlock();
    std::exception_ptr failure;
    try {
      write_(frame);
    } catch (...) { failure = std::current_exception(); }
    lock.lock();

    if (failure && !failure_) failure_ = failure;
    changed_.notify_all();
  }
}

}  // namespace dermis::cli::sequence
