// SPDX-License-Identifier: MIT
#include "tools/dataset/encoders.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

#include "base/core/error.h"

namespace dermis::dataset {
namespace {

constexpr int most_threads = 4096;

}  // namespace

Encoders::Encoders(const Recipe::State& recipe, int threads) : recipe_(recipe) {
  if (threads < 0 || threads > most_threads)
    throw input_error("", "threads must be 0 to {}, got {}", most_threads, threads);
  const unsigned count = threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
  for (unsigned i = 0; i < std::max(count, 1u); ++i) threads_.emplace_back([this] { work(); });
}

Encoders::~Encoders() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::future<Encoded> Encoders::encode(Drawn&& drawn) {
  std::packaged_task<Encoded()> task(
      [this, kept = std::make_shared<Drawn>(std::move(drawn))] { return encoded(recipe_, *kept); });
  std::future<Encoded> result = task.get_future();
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(task));
  }
  changed_.notify_one();
  return result;
}

double Encoders::busy_s() const {
  const std::lock_guard lock(mutex_);
  return busy_s_;
}

void Encoders::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
    if (closed_) return;
    std::packaged_task<Encoded()> task = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    const auto start = std::chrono::steady_clock::now();
    task();
    task = {};  // the memory of its frame goes back to the session
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    lock.lock();
    busy_s_ += took_s;
  }
}

}  // namespace dermis::dataset
