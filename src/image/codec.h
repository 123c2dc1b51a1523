// SPDX-License-Identifier: MIT
// Decodes and encodes picture files. Every limit is checked before memory is taken, so that a hostile file
// ends in InputError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/shrink.h"

namespace dermis::image {

struct DecodeLimits {
  int max_side = 16384;  ///< pixels
  std::size_t max_pixels =
      1u << 28;  ///< width * height; half of this for linear light, whose pixels take 12 bytes
};

/// The header of a PNG or JPEG; nothing else is decoded.
struct PictureHeader {
  int width = 0, height = 0;  ///< pixels
  int channels = 0;           ///< in the file: 1 to 4
  int bits = 8;               ///< per channel
  /// the file holds several passes over the whole picture: an interlaced PNG, a progressive JPEG
  bool many_passes = false;
  bool jpeg = false;
};
/// Reads the header. Throws InputError as decode_image8 does, as far as a header shows.
PictureHeader read_header8(std::span<const std::byte> bytes, const std::string& where,
                           const DecodeLimits& limits = {});

/// Returns the most bytes that decode_image8 takes besides the returned picture: sums of a downsampled
/// interlaced picture, coefficients of a progressive one.
std::uint64_t passing_bytes(const PictureHeader& header, const Shrink& shrink);

/// Decodes PNG or JPEG, recognised by the first bytes, to RGBA8. Grey is copied to R, G and B, a missing
/// alpha is 255, 16-bit PNG is rounded to 8 bits. `where` names the picture in errors. Throws InputError for
/// an unknown format (names KTX2 and WebP), a truncated or damaged file, one over the limits, a progressive
/// JPEG whose coefficients take over 1 GB.
Image8 decode_image8(std::span<const std::byte> bytes, const std::string& where,
                     const DecodeLimits& limits = {}, const Shrink& shrink = {});

/// Decodes Radiance .hdr or OpenEXR, recognised by the first bytes, to 3-channel linear floats. Of EXR: R, G,
/// B or Y of the first part, the data window cropped to the display window. +infinity becomes 65504, the
/// largest half, NaN and -infinity 0, with one warning. A picture of more than `most_pixels` is downsampled
/// by 2 while it is read, by area averages, until it has no more.
ImageF decode_image_f(std::span<const std::byte> bytes, const std::string& where,
                      const DecodeLimits& limits = {}, std::uint64_t most_pixels = ~std::uint64_t{0});

/// Returns what a file holds, by its first bytes: display values (PNG, JPEG) or linear light (HDR, EXR).
/// Throws InputError if neither.
enum class PictureKind { display, linear };
PictureKind picture_kind(std::span<const std::byte> bytes, const std::string& where);

/// Reads a file and decodes it: PNG, JPEG.
Image8 load_image8(const std::filesystem::path& path, const DecodeLimits& limits = {});
/// Reads a file of at most 1 GiB and decodes it: HDR, EXR.
ImageF load_image_f(const std::filesystem::path& path, const DecodeLimits& limits = {},
                    std::uint64_t most_pixels = ~std::uint64_t{0});

/// The time that an encoder searches. fast: a quarter of the time, files a ninth larger (portrait and
/// labels).
enum class PngEffort { small, fast };

/// Returns a PNG in memory (with alpha if keep_alpha, else RGB) that says that it is sRGB, without a date.
std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha = false,
                                  PngEffort effort = PngEffort::small);
/// Writes RGBA8 as PNG (with alpha if keep_alpha, else RGB), atomically; it says that it is sRGB. No
/// date: equal pixels give equal bytes.
void save_png(const std::filesystem::path& path, const Image8& picture, bool keep_alpha = false);
/// Writes 3 or 4 float channels as OpenEXR (ZIP; half if half_float, else 32-bit float) with the primaries of
/// sRGB, atomically and without a date.
void save_exr(const std::filesystem::path& path, const ImageF& picture, bool half_float = false);

}  // namespace dermis::image
