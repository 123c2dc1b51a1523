// SPDX-License-Identifier: MIT
// Decoded pictures that something still holds: many images of a file, and many assets of one file, often name
// the same one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <tuple>

#include "image/image.h"
#include "image/shrink.h"

namespace dermis::scene {

/// Tells encoded pictures apart by their bytes.
struct PictureKey {
  std::uint64_t bytes = 0, first = 0, second = 0;  ///< their number, and two hashes of them
  auto operator<=>(const PictureKey&) const = default;
};
PictureKey key_of(std::span<const std::byte> encoded);

using Pixels = std::shared_ptr<const image::Image8>;

/// Returns the picture if anything holds it, else what `decode` makes. Any thread may call it.
Pixels kept_picture(const PictureKey& key, const image::Shrink& shrink,
                    const std::function<image::Image8()>& decode);

}  // namespace dermis::scene
