// SPDX-License-Identifier: MIT
// PNG through libspng.
#include <spng.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "base/core/error.h"
#include "image/files/formats.h"
#include "image/layers.h"

namespace dermis::image::formats {

namespace {

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, FreeContext>;

// Limits ancillary chunks (text, profiles, thumbnails), which we do not need: a file must not make us store
// many megabytes of them.
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

/// Returns a reader whose header is checked.
Context open(Bytes bytes, const std::string& where, const DecodeLimits& limits, spng_ihdr& header) {
  Context context(spng_ctx_new(0));
  if (!context) throw std::bad_alloc();
  // A wrong checksum of an ancillary chunk does not affect pixels.
  check(spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD), where);
  check(spng_set_chunk_limits(context.get(), chunk_limit_bytes, chunk_limit_bytes), where);
  check(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), where);
  check(spng_get_ihdr(context.get(), &header), where);
  check_size(header.width, header.height, limits, where);
  check_plausible(bytes, least_file_bytes(header), header.width, header.height, where);
  return context;
}

// Adam7: positions of the pixels of each pass in a row.
constexpr int pass_first[] = {0, 4, 0, 2, 0, 1, 0}, pass_step[] = {8, 8, 4, 4, 2, 2, 1};

/// Decodes row by row, an interlaced picture pass by pass, so that the whole picture is never in memory.
template <class Sample, class Take>
void decode_rows(spng_ctx* context, const spng_ihdr& header, int format, const std::string& where,
                 const Take& take) {
  check(spng_decode_image(context, nullptr, 0, format, SPNG_DECODE_TRNS | SPNG_DECODE_PROGRESSIVE), where);
  const int width = static_cast<int>(header.width);
  std::vector<Sample> row(std::size_t{header.width} * 4), pass_row;
  for (int result = SPNG_OK; result != SPNG_EOI;) {
    spng_row_info info{};
    // If the last passes of a small picture are empty, the end shows here.
    result = spng_get_row_info(context, &info);
    if (result == SPNG_EOI) break;
    check(result, where);
    result = spng_decode_row(context, row.data(), row.size() * sizeof(Sample));
    if (result != SPNG_EOI) check(result, where);

    const int first = header.interlace_method ? pass_first[info.pass] : 0,
              step = header.interlace_method ? pass_step[info.pass] : 1;
    if (step == 1) {
      take(static_cast<int>(info.row_num), row.data(), width, 0, 1);
      continue;
    }
    pass_row.clear();
    for (int x = first; x < width; x += step)
      pass_row.insert(pass_row.end(), &row[std::size_t{4} * x], &row[std::size_t{4} * x] + 4);
    take(static_cast<int>(info.row_num), pass_row.data(), static_cast<int>(pass_row.size() / 4), first, step);
  }
}

}  // namespace

PictureHeader png_header(Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  spng_ihdr header{};
  open(bytes, where, limits, header);
  return {.width = static_cast<int>(header.width),
          .height = static_cast<int>(header.height),
          .channels = header.color_type == SPNG_COLOR_TYPE_INDEXED ? 3 : samples_per_pixel(header.color_type),
          .bits = header.bit_depth,
          .many_passes = header.interlace_method != 0,
          .jpeg = false};
}

Image8 decode_png(Bytes bytes, const std::string& where, const DecodeLimits& limits, const Shrink& shrink) {
  spng_ihdr header{};
  const Context context = open(bytes, where, limits, header);
  Shrinking picture(static_cast<int>(header.width), static_cast<int>(header.height), shrink);
  const bool in_order = header.interlace_method == 0;

  if (header.bit_depth == 16) {
    // libspng would drop the low byte; we round.
    decode_rows<std::uint16_t>(context.get(), header, SPNG_FMT_RGBA16, where,
                               [&](int y, const std::uint16_t* rgba, int count, int first, int step) {
                                 picture.row16(y, rgba, count, first, step);
                                 if (in_order) picture.done_to(y);
                               });
  } else {
    decode_rows<std::uint8_t>(context.get(), header, SPNG_FMT_RGBA8, where,
                              [&](int y, const std::uint8_t* rgba, int count, int first, int step) {
                                picture.row8(y, rgba, count, first, step);
                                if (in_order) picture.done_to(y);
                              });
  }

  picture.done_to(static_cast<int>(header.height) - 1);
  // Reads to the end chunk, so that a file cut after its last pixel is detected.
  check(spng_decode_chunks(context.get()), where);

  // The library does not check the checksum of the end chunk, which is always the same.
  constexpr std::string_view end_chunk("IEND\xae\x42\x60\x82");
  if (std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()).rfind(end_chunk) ==
      std::string_view::npos) {
    throw input_error(where, "PNG is truncated");
  }
  return picture.take();
}

namespace {

// Of zlib's 1 to 9, the last that takes matches greedily.
constexpr int fast_level = 3;

// Pixels as `header` says, those of 16 bits in the order of this machine.
std::vector<std::byte> encoded(spng_ihdr header, const void* pixels, std::size_t bytes, bool srgb,
                               const std::string& where, PngEffort effort) {
  const Context context(spng_ctx_new(SPNG_CTX_ENCODER));
  if (!context) throw std::bad_alloc();
  int result = spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  if (result == SPNG_OK) result = spng_set_ihdr(context.get(), &header);
  if (effort == PngEffort::fast) {
    if (result == SPNG_OK) result = spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, fast_level);
    if (result == SPNG_OK)
      result = spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB);
  }
  constexpr std::uint8_t perceptual = 0;  // the intent with which a display with other primaries shows it
  if (result == SPNG_OK && srgb) result = spng_set_srgb(context.get(), perceptual);
  if (result == SPNG_OK)
    result = spng_encode_image(context.get(), pixels, bytes, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t size = 0;
  const std::unique_ptr<void, decltype(&std::free)> file(
      result == SPNG_OK ? spng_get_png_buffer(context.get(), &size, &result) : nullptr, &std::free);
  if (!file) throw input_error(where, "cannot be encoded as PNG: {}", spng_strerror(result));
  std::vector<std::byte> out(size);
  std::memcpy(out.data(), file.get(), size);
  return out;
}

}  // namespace

std::vector<std::byte> encode_png(const Image8& picture, bool keep_alpha, const std::string& where,
                                  PngEffort effort) {
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
  return encoded(header, pixels.data(), pixels.size(), true, where, effort);
}

}  // namespace dermis::image::formats

namespace dermis::image {

std::vector<std::byte> encode_png16(int width, int height, int channels,
                                    std::span<const std::uint16_t> values, const std::string& where,
                                    PngEffort effort) {
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(width);
  header.height = static_cast<std::uint32_t>(height);
  header.bit_depth = 16;
  header.color_type = channels == 3 ? SPNG_COLOR_TYPE_TRUECOLOR : SPNG_COLOR_TYPE_GRAYSCALE;
  return formats::encoded(header, values.data(), values.size_bytes(), false, where, effort);
}

}  // namespace dermis::image
