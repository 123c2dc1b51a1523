// SPDX-License-Identifier: MIT
// Threads that encode pictures while the device draws.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "tools/dataset/members.h"

namespace dermis::dataset {

class Encoders {
 public:
  /// 0 threads: one for each core.
  Encoders(const Recipe::State& recipe, int threads);
  ~Encoders();
  Encoders(const Encoders&) = delete;
  Encoders& operator=(const Encoders&) = delete;

  std::future<Encoded> encode(Drawn&& drawn);
  std::size_t threads() const { return threads_.size(); }
  double busy_s() const;  ///< of all threads together

 private:
  void work();

  const Recipe::State& recipe_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::packaged_task<Encoded()>> waiting_;
  bool closed_ = false;
  double busy_s_ = 0;
  std::vector<std::thread> threads_;
};

}  // namespace dermis::dataset
