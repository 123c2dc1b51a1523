// SPDX-License-Identifier: MIT
#include "head/scene/import/kept_pictures.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "base/core/hash.h"

namespace dermis::scene {
namespace {

/// A picture as it is read: unshrunk, colours and data are the same.
struct ReadKey {
  PictureKey picture;
  int halvings = 0;
  bool srgb = false, deep = false;
  auto operator<=>(const ReadKey&) const = default;
};

class Kept {
 public:
  Pixels find(const ReadKey& key) {
    const std::lock_guard lock(mutex_);
    const auto found = pictures_.find(key);
    return found == pictures_.end() ? nullptr : found->second.lock();
  }
  void add(const ReadKey& key, const Pixels& pixels) {
    const std::lock_guard lock(mutex_);
    // Each entry is looked at a few times at most, however many come and go.
    if (pictures_.size() >= most_) {
      std::erase_if(pictures_, [](const auto& entry) { return entry.second.expired(); });
      most_ = std::max<std::size_t>(64, 2 * pictures_.size());
    }
    pictures_[key] = pixels;
  }

 private:
  std::mutex mutex_;
  std::map<ReadKey, std::weak_ptr<const image::Image8>> pictures_;
  std::size_t most_ = 64;
};

Kept& kept() {
  static Kept all;
  return all;
}

}  // namespace

PictureKey key_of(std::span<const std::byte> encoded) {
  Hash first, second;
  second.word(1);  // another beginning, so that the two agree by chance only
  first.bytes(encoded.data(), encoded.size());
  second.bytes(encoded.data(), encoded.size());
  return {encoded.size(), first.value(), second.value()};
}

Pixels kept_picture(const PictureKey& picture, const image::Shrink& shrink,
                    const std::function<image::Image8()>& decode) {
  const ReadKey key{picture, shrink.halvings, shrink.halvings > 0 && shrink.srgb, shrink.deep};
  if (Pixels pixels = kept().find(key)) return pixels;
  auto pixels = std::make_shared<const image::Image8>(decode());
  kept().add(key, pixels);
  return pixels;
}

}  // namespace dermis::scene
