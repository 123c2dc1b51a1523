// SPDX-License-Identifier: MIT
// Pictures. The formats themselves are other libraries' work; headers, limits, HDR and what comes of the
// pixels are ours.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "image/codec.h"
#include "support.h"

namespace dermis::fuzz {
namespace {

std::size_t pixels_of(int width, int height) {
  DERMIS_ASSERT_LE(1, width);
  DERMIS_ASSERT_LE(1, height);
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void check_pixels(const image::Image8& picture) {
  DERMIS_ASSERT_EQ(picture.rgba.size(), 4 * pixels_of(picture.width, picture.height));
}

void check_pixels(const image::ImageF& picture) {
  DERMIS_ASSERT_EQ(picture.channels, 3);
  DERMIS_ASSERT_EQ(picture.values.size(), 3 * pixels_of(picture.width, picture.height));
  for (const float value : picture.values) DERMIS_ASSERT(std::isfinite(value));
}

/// As it is, and made smaller while it is read.
bool decode8(Bytes file) {
  return accepts([&] {
    const image::PictureHeader header = image::read_header8(file, "picture");
    const image::Image8 picture = image::decode_image8(file, "picture");
    check_pixels(picture);
    DERMIS_ASSERT_EQ(picture.width, header.width);
    DERMIS_ASSERT_EQ(picture.height, header.height);

    for (const image::Shrink shrink : {image::Shrink{1, true}, image::Shrink{3, false}}) {
      const image::Image8 small = image::decode_image8(file, "picture", {}, shrink);
      check_pixels(small);

      const int width = std::max(1, picture.width >> shrink.halvings);
      const int height = std::max(1, picture.height >> shrink.halvings);
      DERMIS_ASSERT_EQ(small.width, width);
      DERMIS_ASSERT_EQ(small.height, height);
    }
  });
}

bool decode_f(Bytes file) {
  constexpr std::uint64_t few_pixels = 16;
  return accepts([&] {
    check_pixels(image::decode_image_f(file, "picture"));

    const image::ImageF small = image::decode_image_f(file, "picture", {}, few_pixels);
    check_pixels(small);
    DERMIS_ASSERT_LE(pixels_of(small.width, small.height), few_pixels);
  });
}

std::uint32_t crc32(Bytes bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::byte b : bytes) {
    crc ^= static_cast<std::uint32_t>(b);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xedb88320u & (0u - (crc & 1)));
  }
  return ~crc;
}

std::size_t big_endian(Bytes four) {
  std::size_t value = 0;
  for (const std::byte b : four) value = value << 8 | static_cast<std::size_t>(b);
  return value;
}

/// A chunk is its length, its type, so many bytes, and the checksum of type and bytes.
std::vector<std::byte> with_right_checksums(Bytes file) {
  constexpr std::size_t signature = 8, around = 12;
  std::vector<std::byte> png(file.begin(), file.end());

  for (std::size_t at = signature; at + around <= png.size();) {
    const std::size_t length = big_endian(Bytes(png).subspan(at, 4));
    if (length > png.size() - at - around) break;
    const std::uint32_t crc = crc32(Bytes(png).subspan(at + 4, 4 + length));
    for (std::size_t i = 0; i < 4; ++i)
      png[at + 8 + length + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
    at += around + length;
  }
  return png;
}

}  // namespace

bool png(Bytes file) { return decode8(with_right_checksums(file)); }
bool jpeg(Bytes file) { return decode8(file); }
bool hdr(Bytes file) { return decode_f(file); }
bool exr(Bytes file) { return decode_f(file); }

}  // namespace dermis::fuzz
