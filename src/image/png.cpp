// SPDX-License-Identifier: MIT
// PNG through libspng.
#include <spng.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/error.h"
#include "image/formats.h"

namespace dermis::image::formats {

namespace {

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, FreeContext>;

// Ancillary chunks (text, profiles, thumbnails) are of no use here; a file must not make us store many
// megabytes of them.
constexpr std::size_t chunk_limit_bytes = std::size_t{16} << 20;

void check(int result, const std::string& where) {
  if (result == SPNG_OK) return;
  if (result == SPNG_IO_EOF || result == SPNG_EIDAT_TOO_SHORT) throw input_error(where, "PNG is truncated");
  throw input_error(where, "PNG is damaged: {}", spng_strerror(result));
}

int samples_per_pixel(int colour_type) {
  switch (colour_type) {
    case SPNG_COLOR_TYPE_TRUECOLOR: return 3;
    case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA: return 2;
    case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA: return 4;
    default: return 1;
  }
}

// Deflate packs at most 1032 bytes into one (258 bytes in two bits).
std::uint64_t least_file_bytes(const spng_ihdr& header) {
  const std::uint64_t bits = std::uint64_t{header.width} * header.bit_depth *
                             static_cast<unsigned>(samples_per_pixel(header.color_type));
  return header.height * ((bits + 7) / 8 + 1) / 1032;
}

std::uint8_t nearest8(std::uint16_t value) {
  return static_cast<std::uint8_t>((value * 255u + 32767u) / 65535u);
}

}  // namespace

Image8 decode_png(Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  const Context context(spng_ctx_new(0));
  if (!context) throw std::bad_alloc();
  // A wrong checksum of an ancillary chunk does not touch the pixels.
  check(spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD), where);
  check(spng_set_chunk_limits(context.get(), chunk_limit_bytes, chunk_limit_bytes), where);
  check(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), where);
  spng_ihdr header{};
  check(spng_get_ihdr(context.get(), &header), where);
  check_size(header.width, header.height, limits, where);
  check_plausible(bytes, least_file_bytes(header), header.width, header.height, where);

  Image8 picture{
      .width = static_cast<int>(header.width), .height = static_cast<int>(header.height), .rgba = {}};
  const std::size_t samples = std::size_t{header.width} * header.height * 4;
  picture.rgba.resize(samples);
  if (header.bit_depth == 16) {
    // libspng would cut the low byte off; we round.
    std::vector<std::uint16_t> wide(samples);
    check(spng_decode_image(context.get(), wide.data(), samples * 2, SPNG_FMT_RGBA16, SPNG_DECODE_TRNS),
          where);
    for (std::size_t i = 0; i < samples; ++i) picture.rgba[i] = nearest8(wide[i]);
  } else {
    check(spng_decode_image(context.get(), picture.rgba.data(), samples, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS),
          where);
  }
  // Reads on to the end chunk, so that a file cut after its last pixel is noticed too.
  check(spng_decode_chunks(context.get()), where);
  // The library does not ask for the checksum of the end chunk, which is always the same.
  constexpr std::string_view end_chunk("IEND\xae\x42\x60\x82");
  if (std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).rfind(end_chunk) ==
      std::string_view::npos) {
    throw input_error(where, "PNG is truncated");
  }
  return picture;
}

std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha, const std::string& where) {
  const Context context(spng_ctx_new(SPNG_CTX_ENCODER));
  if (!context) throw std::bad_alloc();
  std::vector<std::uint8_t> rgb;
  if (!keep_alpha) {
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
      rgb.insert(rgb.end(), &picture.rgba[i], &picture.rgba[i] + 3);
  }
  const std::vector<std::uint8_t>& pixels = keep_alpha ? picture.rgba : rgb;

  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(picture.width);
  header.height = static_cast<std::uint32_t>(picture.height);
  header.bit_depth = 8;
  header.color_type = keep_alpha ? SPNG_COLOR_TYPE_TRUECOLOR_ALPHA : SPNG_COLOR_TYPE_TRUECOLOR;
  int result = spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  if (result == SPNG_OK) result = spng_set_ihdr(context.get(), &header);
  if (result == SPNG_OK)
    result =
        spng_encode_image(context.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t size = 0;
  const std::unique_ptr<void, decltype(&std::free)> file(
      result == SPNG_OK ? spng_get_png_buffer(context.get(), &size, &result) : nullptr, &std::free);
  if (!file) throw input_error(where, "cannot be encoded as PNG: {}", spng_strerror(result));
  std::vector<std::byte> bytes(size);
  std::memcpy(bytes.data(), file.get(), size);
  return bytes;
}

}  // namespace dermis::image::formats
