// SPDX-License-Identifier: MIT
// Uploads large textures in pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/resources.h"

namespace dermis::gpu {

/// Fills a texture of one layer piece by piece through a small staging buffer, so that the host memory does
/// not grow with the texture. Takes every row of every mip once, in any order; then finish().
class TextureUpload {
 public:
  TextureUpload(Device& device, const Texture& to);
  ~TextureUpload();
  TextureUpload(const TextureUpload&) = delete;
  TextureUpload& operator=(const TextureUpload&) = delete;

  /// Returns the number of rows of a mip that may be given at a time, at least 1.
  std::uint32_t rows_at_a_time(std::uint32_t mip) const;
  /// Uploads whole rows, tightly packed; waits until done.
  void rows(std::uint32_t mip, std::uint32_t first_row, std::span<const std::byte> bytes);
  /// Leaves the texture in SHADER_READ_ONLY_OPTIMAL.
  void finish();

 private:
  Device* device_;
  const Texture* to_;
  Buffer staging_;
};

}  // namespace dermis::gpu
