// SPDX-License-Identifier: MIT
#include "api/readbacks.h"

#include <algorithm>
#include <utility>

namespace dermis::api {
namespace {

constexpr std::size_t most_kept = 3;  // Session::Options::frames_in_flight

std::unique_ptr<Readback> made(gpu::Device& device, const ReadbackSizes& sizes) {
  const auto buffer = [&](const char* name, std::uint64_t bytes) {
    return bytes == 0 ? gpu::Buffer()
                      : gpu::Buffer(device, name, {.bytes = bytes, .place = gpu::BufferPlace::readback});
  };
  return std::make_unique<Readback>(Readback{.sizes = sizes,
                                             .display = buffer("display values to read", sizes.display),
                                             .linear = buffer("linear picture to read", sizes.linear),
                                             .matte = buffer("matte to read", sizes.matte),
                                             .labels = buffer("labels to read", sizes.labels)});
}

}  // namespace

std::unique_ptr<Readback> Readbacks::take(gpu::Device& device, const ReadbackSizes& sizes) {
  std::vector<std::unique_ptr<Readback>> surplus;  // destroyed after the lock
  std::unique_ptr<Readback> found;
  {
    const std::lock_guard lock(mutex_);
    const auto of_others = std::partition(free_.begin(), free_.end(),
                                          [&](const auto& readback) { return readback->sizes == sizes; });
    surplus.insert(surplus.end(), std::make_move_iterator(of_others), std::make_move_iterator(free_.end()));
    free_.erase(of_others, free_.end());
    if (!free_.empty()) {
      found = std::move(free_.back());
      free_.pop_back();
    }
    while (free_.size() > most_kept) {
      surplus.push_back(std::move(free_.back()));
      free_.pop_back();
    }
  }
  surplus.clear();
  return found ? std::move(found) : made(device, sizes);
}

void Readbacks::give(std::unique_ptr<Readback> readback) {
  const std::lock_guard lock(mutex_);
  free_.push_back(std::move(readback));
}

}  // namespace dermis::api
