// SPDX-License-Identifier: MIT
// Files made in memory for the tests, by the libraries themselves, so that our readers meet formats that our
// writers do not write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec.h"

namespace dermis::image::test {

using Bytes = std::vector<std::byte>;

/// samples: as stored, 16-bit ones in host order; colour_type as in the PNG specification (0 grey, 2 RGB, 3
/// palette, 4 grey + alpha, 6 RGBA).
struct PngRecipe {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint8_t bit_depth = 8;
  std::uint8_t colour_type = 6;
  bool interlaced = false;
  std::vector<std::uint8_t> palette_rgba;  ///< 4 bytes an entry
  int transparent_grey = -1;
};
Bytes make_png(const PngRecipe& recipe, std::span<const std::uint8_t> samples);

enum class JpegKind { rgb, grey, cmyk, progressive };
/// samples: width * height * (1, 3 or 4); quality 95, no subsampling.
Bytes make_jpeg(int width, int height, JpegKind kind, std::span<const std::uint8_t> samples);

struct ExrRecipe {
  int x = 0, y = 0, width = 1, height = 1;  ///< data window
  /// display window; width 0: as the data window
  int show_x = 0, show_y = 0, show_width = 0, show_height = 0;
  std::string channels = "RGB";  ///< one letter each
  int compression = 3;           ///< ZIP; the number of the file format
  int tile = 0;                  ///< 0: rows
};
/// values: interleaved in the order of recipe.channels, written as floats.
Bytes make_exr(const ExrRecipe& recipe, std::span<const float> values);

Bytes bytes_of(std::string_view text);
/// What the decoder says, or "no error". Other exceptions pass.
std::string error_of8(std::span<const std::byte> bytes, const DecodeLimits& limits = {});
std::string error_of_f(std::span<const std::byte> bytes, const DecodeLimits& limits = {});

/// Repeatable noise: 0..255 each.
std::vector<std::uint8_t> noise(std::size_t count, std::uint32_t seed);

}  // namespace dermis::image::test
