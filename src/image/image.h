// SPDX-License-Identifier: MIT
// Pixels in memory. Rows run from top to bottom; pixels are interleaved, no padding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dermis::image {

/// 8 bits per channel, always four channels (RGBA): a decoded colour or data map. Values are as stored,
/// without colour conversion.
struct Image8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< width * height * 4
  /// The same at 16 bits, where the file has them and they were asked for (Shrink::deep); else empty.
  std::vector<std::uint16_t> rgba16{};

  /// Returns a stored value, 0 to 255, as finely as it is there.
  float value(int x, int y, int channel) const {
    const std::size_t i = (static_cast<std::size_t>(y) * width + x) * 4 + channel;
    return rgba16.empty() ? static_cast<float>(rgba[i]) : static_cast<float>(rgba16[i]) / 257.0f;
  }
  std::uint8_t* at(int x, int y) { return rgba.data() + (static_cast<std::size_t>(y) * width + x) * 4; }
  const std::uint8_t* at(int x, int y) const {
    return rgba.data() + (static_cast<std::size_t>(y) * width + x) * 4;
  }
};

/// 32-bit floats, `channels` per pixel (1 to 4): radiance, heights, anything not bounded by 1.
struct ImageF {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> values;  ///< width * height * channels

  float* at(int x, int y) { return values.data() + (static_cast<std::size_t>(y) * width + x) * channels; }
  const float* at(int x, int y) const {
    return values.data() + (static_cast<std::size_t>(y) * width + x) * channels;
  }
};

}  // namespace dermis::image
