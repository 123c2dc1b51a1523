// SPDX-License-Identifier: MIT
// Large textures go to the device in pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/resources.h"

namespace dermis::gpu {

/// Fills a texture of one layer piece by piece, through a small staging buffer: what a large one takes on the
/// way does not grow with it. Every row of every mip once, in any order; then finish().
class TextureUpload {
 public:
  TextureUpload(Device& device, const Texture& to);
  ~TextureUpload();
  TextureUpload(const TextureUpload&) = delete;
  TextureUpload& operator=(const TextureUpload&) = delete;

  /// How many rows of a mip may be given at a time, at least 1.
  std::uint32_t rows_at_a_time(std::uint32_t mip) const;
  /// Whole rows, tightly packed; waits until done.
  void rows(std::uint32_t mip, std::uint32_t first_row, std::span<const std::byte> bytes);
  /// The texture ends in SHADER_READ_ONLY_OPTIMAL.
  void finish();

 private:
  Device* device_;
  const Texture* to_;
  Buffer staging_;
};

}  // namespace dermis::gpu
