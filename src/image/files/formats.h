// SPDX-License-Identifier: MIT
// Functions per format for codec.cpp. Each throws InputError and leaves nothing behind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec.h"
#include "image/shrink.h"

namespace dermis::image::formats {

using Bytes = std::span<const std::byte>;

/// Returns text of a file, fit for an error message: control and non-ASCII characters become '?', cut after
/// 200.
std::string printable(std::string_view text);

/// Throws InputError unless 1 <= width, height <= max_side and their product <= max_pixels.
void check_size(std::int64_t width, std::int64_t height, const DecodeLimits& limits,
                const std::string& where);

/// Throws InputError if the file is too short for its pixels even at the best compression ratio. So a few
/// bytes that claim a huge picture are rejected before memory is taken. least_bytes: size of the smallest
/// such file.
void check_plausible(Bytes bytes, std::uint64_t least_bytes, std::int64_t width, std::int64_t height,
                     const std::string& where);

PictureHeader png_header(Bytes bytes, const std::string& where, const DecodeLimits& limits);
PictureHeader jpeg_header(Bytes bytes, const std::string& where, const DecodeLimits& limits);
Image8 decode_png(Bytes bytes, const std::string& where, const DecodeLimits& limits, const Shrink& shrink);
Image8 decode_jpeg(Bytes bytes, const std::string& where, const DecodeLimits& limits, const Shrink& shrink);
ImageF decode_hdr(Bytes bytes, const std::string& where, const DecodeLimits& limits,
                  std::uint64_t most_pixels);
ImageF decode_exr(Bytes bytes, const std::string& where, const DecodeLimits& limits,
                  std::uint64_t most_pixels);

/// Collects a linear picture of 3 channels row by row, from the top or from the bottom, and downsamples it by
/// 2 until it has no more than `most_pixels`. Of values that are not finite +infinity becomes max_half,
/// because it is the brightest light (a sun, clipped), the others 0; they are counted.
class Collected {
 public:
  Collected(int width, int height, std::uint64_t most_pixels);
  Collected(const Collected&) = delete;
  Collected& operator=(const Collected&) = delete;
  void row(int y, std::span<float> rgb);
  /// Returns the picture; warns if pixels were not finite, and notes if it was downsampled.
  ImageF take(const std::string& where);

 private:
  void keep(int y, std::span<const float> rgb);
  ImageF picture_;
  int source_width_, source_height_;
  std::optional<AreaAverage> average_;
  bool from_top_ = true;
  int rows_ = 0;  ///< rows received
  std::size_t not_finite_ = 0;
};

std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha, const std::string& where,
                                  PngEffort effort = PngEffort::small);
std::vector<std::byte> encode_exr(const ImageF& picture, bool half_float, const std::string& where);

}  // namespace dermis::image::formats
