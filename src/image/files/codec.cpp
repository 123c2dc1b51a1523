// SPDX-License-Identifier: MIT
#include "image/codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/log.h"
#include "image/colour.h"
#include "image/files/formats.h"

namespace dermis::image {

namespace formats {

std::string printable(std::string_view text) {
  std::string clean(text.substr(0, 200));
  std::replace_if(
      clean.begin(), clean.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return clean;
}

void check_size(std::int64_t width, std::int64_t height, const DecodeLimits& limits,
                const std::string& where) {
  if (width < 1 || height < 1) throw input_error(where, "has no pixels ({} x {})", width, height);
  if (width > limits.max_side || height > limits.max_side) {
    throw input_error(where, "is {} x {} pixels, the limit is {} per side", width, height, limits.max_side);
  }
  if (static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > limits.max_pixels) {
    throw input_error(where, "is {} x {} pixels, the limit is {} in all", width, height, limits.max_pixels);
  }
}

void check_plausible(Bytes bytes, std::uint64_t least_bytes, std::int64_t width, std::int64_t height,
                     const std::string& where) {
  if (bytes.size() < least_bytes) {
    throw input_error(where, "is truncated or damaged: {} bytes cannot hold {} x {} pixels", bytes.size(),
                      width, height);
  }
}

Collected::Collected(int width, int height, std::uint64_t most_pixels)
    : source_width_(width), source_height_(height) {
  DERMIS_ASSERT_LE(1u, most_pixels);
  const auto pixels = [](int w, int h) { return static_cast<std::uint64_t>(w) * static_cast<unsigned>(h); };
  int halvings = 0;
  while (pixels(halved(width, halvings), halved(height, halvings)) > most_pixels) ++halvings;
  picture_ = {
      .width = halved(width, halvings), .height = halved(height, halvings), .channels = 3, .values = {}};
  picture_.values.reserve(pixels(picture_.width, picture_.height) * 3);
  if (halvings == 0) return;
  average_.emplace(AreaAverage::Size{width, height}, AreaAverage::Size{picture_.width, picture_.height}, 3,
                   [this](int y, std::span<const float> values) { keep(y, values); });
}

void Collected::row(int y, std::span<float> rgb) {
  for (float& value : rgb) {
    if (std::isfinite(value)) continue;
    value = value > 0 ? max_half : 0.0f;  // NaN compares false
    ++not_finite_;
  }
  if (!average_) return keep(y, rgb);
  // If the lowest row comes first, sums are kept until the topmost row has come.
  if (y == source_height_ - 1 && source_height_ > 1) from_top_ = rows_ > 0;
  ++rows_;
  average_->add(y, rgb);
  if (from_top_) average_->done_to(y);
}

// Takes memory as rows arrive: if a picture claims to be much larger than its file, the first damaged row
// ends the reading.
void Collected::keep(int y, std::span<const float> rgb) {
  const std::size_t end = (static_cast<std::size_t>(y) + 1) * rgb.size();
  if (picture_.values.size() < end) picture_.values.resize(end);
  std::ranges::copy(rgb, picture_.at(0, y));
}

ImageF Collected::take(const std::string& where) {
  if (average_) {
    average_->done_to(source_height_ - 1);
    note("{}: {} x {} pixels, read as {} x {}", where, source_width_, source_height_, picture_.width,
         picture_.height);
  }
  if (not_finite_ != 0)
    warn("{}: {} values are infinite or not numbers; infinite ones are read as {}, others as 0", where,
         not_finite_, max_half);
  return std::move(picture_);
}

}  // namespace formats

namespace {

using formats::Bytes;

enum class Format { unknown, png, jpeg, hdr, exr, not_read };

struct Signature {
  Format format;
  std::string_view name;
  std::size_t offset;
  std::string_view bytes;
};

using namespace std::string_view_literals;

// "not_read" formats serve to name them in the error: they occur in glTF files and asset folders.
constexpr std::array signatures = {
    Signature{Format::png, "PNG", 0, "\x89PNG\r\n\x1a\n"sv},
    Signature{Format::jpeg, "JPEG", 0, "\xff\xd8\xff"sv},
    Signature{Format::hdr, "Radiance HDR", 0, "#?"sv},
    Signature{Format::exr, "OpenEXR", 0, "\x76\x2f\x31\x01"sv},
    Signature{Format::not_read, "KTX2", 0, "\xabKTX 20\xbb\r\n\x1a\n"sv},
    Signature{Format::not_read, "KTX", 0, "\xabKTX 11\xbb\r\n\x1a\n"sv},
    Signature{Format::not_read, "WebP", 8, "WEBP"sv},
    Signature{Format::not_read, "AVIF", 4, "ftypavif"sv},
    Signature{Format::not_read, "JPEG XL", 0, "\xff\x0a"sv},
    Signature{Format::not_read, "DDS", 0, "DDS "sv},
    Signature{Format::not_read, "GIF", 0, "GIF8"sv},
    Signature{Format::not_read, "TIFF", 0, "II*\0"sv},
    Signature{Format::not_read, "TIFF", 0, "MM\0*"sv},
    Signature{Format::not_read, "BMP", 0, "BM"sv},
};

struct Recognised {
  Format format = Format::unknown;
  std::string_view name;
};

Recognised recognise(Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const Signature& s : signatures) {
    if (text.size() >= s.offset && text.substr(s.offset).starts_with(s.bytes)) return {s.format, s.name};
  }
  return {};
}

[[noreturn]] void refuse(const Recognised& found, const std::string& where, std::string_view expected) {
  if (found.format == Format::unknown)
    throw input_error(where, "is of an unknown picture format, expected {}", expected);
  throw input_error(where, "is a {} picture, expected {}", found.name, expected);
}

constexpr std::uint64_t most_file_bytes = std::uint64_t{1} << 30;  // of a linear picture

void check_shape(std::size_t values, int width, int height, int channels) {
  DERMIS_ASSERT_LE(1, width);
  DERMIS_ASSERT_LE(1, height);
  DERMIS_ASSERT_EQ(values, static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                               static_cast<std::size_t>(channels));
}

}  // namespace

PictureHeader read_header8(Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  const Recognised found = recognise(bytes);
  if (found.format == Format::png) return formats::png_header(bytes, where, limits);
  if (found.format == Format::jpeg) return formats::jpeg_header(bytes, where, limits);
  refuse(found, where, "PNG or JPEG");
}

std::uint64_t passing_bytes(const PictureHeader& header, const Shrink& shrink) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(header.width) * header.height;
  if (!header.many_passes) return 0;
  // JPEG: two bytes per coefficient. PNG: four floats per pixel that is kept.
  if (header.jpeg) return pixels * 2 * static_cast<unsigned>(header.channels);
  return shrink.halvings == 0 ? 0 : (pixels * 16) >> (2 * std::min(shrink.halvings, 31));
}

Image8 decode_image8(Bytes bytes, const std::string& where, const DecodeLimits& limits,
                     const Shrink& shrink) {
  const Recognised found = recognise(bytes);
  if (found.format == Format::png) return formats::decode_png(bytes, where, limits, shrink);
  if (found.format == Format::jpeg) return formats::decode_jpeg(bytes, where, limits, shrink);
  refuse(found, where, "PNG or JPEG");
}

ImageF decode_image_f(Bytes bytes, const std::string& where, const DecodeLimits& limits,
                      std::uint64_t most_pixels) {
  const Recognised found = recognise(bytes);
  // Linear light takes three times the bytes per pixel of a display picture.
  DecodeLimits linear = limits;
  linear.max_pixels /= 2;
  if (found.format == Format::hdr) return formats::decode_hdr(bytes, where, linear, most_pixels);
  if (found.format == Format::exr) return formats::decode_exr(bytes, where, linear, most_pixels);
  refuse(found, where, "Radiance HDR or OpenEXR");
}

PictureKind picture_kind(Bytes bytes, const std::string& where) {
  const Recognised found = recognise(bytes);
  if (found.format == Format::png || found.format == Format::jpeg) return PictureKind::display;
  if (found.format == Format::hdr || found.format == Format::exr) return PictureKind::linear;
  refuse(found, where, "PNG, JPEG, Radiance HDR or OpenEXR");
}

Image8 load_image8(const std::filesystem::path& path, const DecodeLimits& limits) {
  return decode_image8(read_file(path), path.string(), limits);
}

ImageF load_image_f(const std::filesystem::path& path, const DecodeLimits& limits,
                    std::uint64_t most_pixels) {
  return decode_image_f(read_file(path, most_file_bytes), path.string(), limits, most_pixels);
}

std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha, PngEffort effort) {
  check_shape(picture.rgba.size(), picture.width, picture.height, 4);
  return formats::encode_png(picture, keep_alpha, "PNG", effort);
}

void save_png(const std::filesystem::path& path, const Image8& picture, bool keep_alpha) {
  check_shape(picture.rgba.size(), picture.width, picture.height, 4);
  check_writable(path);
  write_file(path, formats::encode_png(picture, keep_alpha, path.string()));
}

void save_exr(const std::filesystem::path& path, const ImageF& picture, bool half_float) {
  check_shape(picture.values.size(), picture.width, picture.height, picture.channels);
  DERMIS_ASSERT(picture.channels == 3 || picture.channels == 4);
  check_writable(path);
  write_file(path, formats::encode_exr(picture, half_float, path.string()));
}

}  // namespace dermis::image
