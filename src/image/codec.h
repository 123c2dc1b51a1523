// SPDX-License-Identifier: MIT
// Decoding and encoding of picture files. Every limit is checked before memory is taken, so a hostile file
// ends in InputError.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"

namespace dermis::image {

struct DecodeLimits {
  int max_side = 16384;               ///< pixels
  std::size_t max_pixels = 1u << 28;  ///< width * height; of linear light, which takes 12 bytes each, half
};

/// What the header of a PNG or JPEG says; nothing is decoded for it.
struct PictureHeader {
  int width = 0, height = 0;  ///< pixels
  int channels = 0;           ///< of the file: 1 to 4
  int bits = 8;               ///< a channel
  /// comes in several passes over the whole picture: an interlaced PNG, a progressive JPEG
  bool many_passes = false;
  bool jpeg = false;
};
/// InputError: as decode_image8, as far as a header can tell.
PictureHeader read_header8(std::span<const std::byte> bytes, const std::string& where,
                           const DecodeLimits& limits = {});

/// How a picture is made smaller while it is read: both sides halved so often (rounded down, at least 1),
/// each pixel the exact average of its area; `srgb`: colours in linear light, weighted by alpha, else plain
/// data.
struct Shrink {
  int halvings = 0;
  bool srgb = false;
};

/// What decode_image8 takes besides the picture that it returns, bytes, at most: sums of an interlaced
/// picture that is made smaller, coefficients of a progressive one.
std::uint64_t passing_bytes(const PictureHeader& header, const Shrink& shrink);

/// PNG or JPEG, told apart by their first bytes, to RGBA8 (grey is spread, a missing alpha is 255; 16-bit PNG
/// is rounded to 8 bits). `where` names the picture in errors. InputError: unknown format (KTX2 and WebP are
/// named), truncated, damaged, over the limits; a progressive JPEG whose coefficients take over 1 GB.
Image8 decode_image8(std::span<const std::byte> bytes, const std::string& where,
                     const DecodeLimits& limits = {}, const Shrink& shrink = {});

/// Radiance .hdr or OpenEXR, told apart by their first bytes, to 3-channel linear floats (EXR: R, G, B or Y
/// of the first part; data window cropped to the display window). NaN and infinite pixels become 0 with one
/// warning. A picture of more than `most_pixels` is halved while it is read, by the average of areas, until
/// it has no more.
ImageF decode_image_f(std::span<const std::byte> bytes, const std::string& where,
                      const DecodeLimits& limits = {}, std::uint64_t most_pixels = ~std::uint64_t{0});

/// What a file holds, by its first bytes: display values (PNG, JPEG) or linear light (HDR, EXR). InputError:
/// neither.
enum class PictureKind { display, linear };
PictureKind picture_kind(std::span<const std::byte> bytes, const std::string& where);

/// Reads a file and decodes it: PNG, JPEG.
Image8 load_image8(const std::filesystem::path& path, const DecodeLimits& limits = {});
/// Reads a file of at most 1 GiB and decodes it: HDR, EXR.
ImageF load_image_f(const std::filesystem::path& path, const DecodeLimits& limits = {},
                    std::uint64_t most_pixels = ~std::uint64_t{0});

/// A PNG in memory (alpha kept when keep_alpha, else RGB), with no date or other metadata.
std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha = false);
/// Writes RGBA8 as PNG (alpha kept when keep_alpha, else RGB), atomically. No date or other metadata: equal
/// pixels give equal bytes.
void save_png(const std::filesystem::path& path, const Image8& picture, bool keep_alpha = false);
/// Writes 3 or 4 float channels as OpenEXR (ZIP; half if half_float, else 32-bit float), atomically and
/// without a date.
void save_exr(const std::filesystem::path& path, const ImageF& picture, bool half_float = false);

}  // namespace dermis::image
