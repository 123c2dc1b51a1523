// SPDX-License-Identifier: MIT
// What codec.cpp calls, one function a format. Each throws InputError and leaves nothing behind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec.h"

namespace dermis::image::formats {

using Bytes = std::span<const std::byte>;

/// Text from inside a file, fit for a line of an error: control and non-ASCII characters become '?', and it
/// is cut after 200.
std::string printable(std::string_view text);

/// InputError unless 1 <= width, height <= max_side and their product <= max_pixels.
void check_size(std::int64_t width, std::int64_t height, const DecodeLimits& limits,
                const std::string& where);

/// InputError if the file is too short to hold its pixels even at the best ratio of its compression: a few
/// bytes that claim a huge picture are refused before memory for it is taken. least_bytes is what the
/// smallest file of that size would have.
void check_plausible(Bytes bytes, std::uint64_t least_bytes, std::int64_t width, std::int64_t height,
                     const std::string& where);

Image8 decode_png(Bytes bytes, const std::string& where, const DecodeLimits& limits);
Image8 decode_jpeg(Bytes bytes, const std::string& where, const DecodeLimits& limits);
ImageF decode_hdr(Bytes bytes, const std::string& where, const DecodeLimits& limits);
ImageF decode_exr(Bytes bytes, const std::string& where, const DecodeLimits& limits);

std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha, const std::string& where);
std::vector<std::byte> encode_exr(const ImageF& picture, bool half_float, const std::string& where);

}  // namespace dermis::image::formats
