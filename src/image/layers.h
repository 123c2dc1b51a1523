// SPDX-License-Identifier: MIT
// Numbers per pixel that are no colours: labels, as layers of one file or as a file each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/codec.h"

namespace dermis::image {

/// A channel of a file of layers, four bytes per value, rows from top to bottom.
struct LayerChannel {
  std::string name;                  ///< "depth.Z": layer and channel
  bool whole = false;                ///< 32-bit whole numbers; else 32-bit floats
  const std::byte* first = nullptr;  ///< of the first pixel
  std::size_t pixel_bytes = 4;       ///< from one pixel to the next
};

/// Returns an OpenEXR file in memory (ZIP, without a date): equal values give equal bytes. `where` names it
/// in errors.
std::vector<std::byte> encode_layers(int width, int height, std::span<const LayerChannel> channels,
                                     const std::string& where);

/// Returns a PNG of 16 bits per value, grey (1 channel) or RGB (3), that says nothing of a colour space.
std::vector<std::byte> encode_png16(int width, int height, int channels,
                                    std::span<const std::uint16_t> values, const std::string& where,
                                    PngEffort effort = PngEffort::small);

}  // namespace dermis::image
