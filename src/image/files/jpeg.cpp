// SPDX-License-Identifier: MIT
// JPEG through the libjpeg interface of libjpeg-turbo.
#include <csetjmp>
#include <cstdio>
// jpeglib.h needs stdio.h before it and does not include it.
#include <jpeglib.h>
// Message codes, after jpeglib.h.
#include <jerror.h>

#include "base/core/error.h"
#include "base/core/log.h"
#include "image/files/formats.h"

namespace dermis::image::formats {

namespace {

// A progressive file may repeat scans without end, each a pass over the whole picture; encoders write at most
// a dozen.
constexpr int max_scans = 200;
constexpr std::uint64_t max_coefficient_bytes = 1'000'000'000;

/// The library reports errors by a callback, which jumps to `escape`. So the functions that set it may hold
/// no object with a destructor.
struct Reader {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf escape{};
  char message[JMSG_LENGTH_MAX] = "";
  char warning[JMSG_LENGTH_MAX] = "";
  bool truncated = false;
  bool too_many_scans = false;

  Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { jpeg_destroy_decompress(&info); }
};

Reader& reader_of(j_common_ptr info) { return *static_cast<Reader*>(info->client_data); }

[[noreturn]] void fail(j_common_ptr info) {
  Reader& reader = reader_of(info);
  info->err->format_message(info, reader.message);
  std::longjmp(reader.escape, 1);
}

// Rejects files with missing or broken data, for which the library only warns and makes up grey pixels.
void on_message(j_common_ptr info, int level) {
  if (level >= 0) return;  // traces
  Reader& reader = reader_of(info);
  switch (info->err->msg_code) {
    case JWRN_JPEG_EOF:
    case JWRN_HIT_MARKER: reader.truncated = true; fail(info);
    case JWRN_HUFF_BAD_CODE:
    case JWRN_ARITH_BAD_CODE:
    case JWRN_MUST_RESYNC: fail(info);
    default: info->err->format_message(info, reader.warning);
  }
}

void on_progress(j_common_ptr info) {
  Reader& reader = reader_of(info);
  if (reader.info.input_scan_number <= max_scans) return;
  reader.too_many_scans = true;
  fail(info);
}

bool read_header(Reader& reader, const unsigned char* bytes, std::size_t size) {
  reader.info.err = jpeg_std_error(&reader.errors);
  reader.errors.error_exit = fail;
  reader.errors.emit_message = on_message;
  reader.info.client_data = &reader;
  if (setjmp(reader.escape) != 0) return false;
  jpeg_create_decompress(&reader.info);
  reader.progress.progress_monitor = on_progress;
  reader.info.progress = &reader.progress;
  jpeg_mem_src(&reader.info, bytes, size);
  return jpeg_read_header(&reader.info, TRUE) == JPEG_HEADER_OK;
}

bool read_pixels(Reader& reader, unsigned char* rgba, Shrinking& picture) {
  if (setjmp(reader.escape) != 0) return false;
  reader.info.out_color_space = JCS_EXT_RGBA;  // alpha is filled with 255
  reader.info.dct_method = JDCT_ISLOW;
  jpeg_start_decompress(&reader.info);
  while (reader.info.output_scanline < reader.info.output_height) {
    JSAMPROW row = rgba;
    const int y = static_cast<int>(reader.info.output_scanline);
    jpeg_read_scanlines(&reader.info, &row, 1);
    picture.row8(y, rgba, static_cast<int>(reader.info.output_width));
    picture.done_to(y);
  }
  jpeg_finish_decompress(&reader.info);
  return true;
}

[[noreturn]] void refuse(const Reader& reader, const std::string& where) {
  if (reader.too_many_scans) throw input_error(where, "JPEG has more than {} scans", max_scans);
  throw input_error(where, "JPEG is {}: {}", reader.truncated ? "truncated" : "damaged", reader.message);
}

/// Reads the header into `reader` and checks it.
void open(Reader& reader, Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  if (!read_header(reader, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()))
    refuse(reader, where);
  const std::int64_t width = reader.info.image_width;
  const std::int64_t height = reader.info.image_height;
  check_size(width, height, limits, where);
  // A block of 8 x 8 samples takes at least one bit; arithmetic coding has no such bound.
  if (!reader.info.arith_code)
    check_plausible(bytes, static_cast<std::uint64_t>(width * height) / 512, width, height, where);
  if (reader.info.jpeg_color_space == JCS_CMYK || reader.info.jpeg_color_space == JCS_YCCK) {
    throw input_error(where, "JPEG has CMYK colours, expected RGB or grey");
  }
}

/// Returns the memory that the library needs for a picture in several passes: every coefficient, two bytes
/// each.
std::uint64_t coefficient_bytes(const Reader& reader) {
  if (!jpeg_has_multiple_scans(const_cast<jpeg_decompress_struct*>(&reader.info))) return 0;
  std::uint64_t blocks = 0;
  for (int c = 0; c < reader.info.num_components; ++c)
    blocks +=
        std::uint64_t{reader.info.comp_info[c].width_in_blocks} * reader.info.comp_info[c].height_in_blocks;
  return blocks * DCTSIZE2 * sizeof(JCOEF);
}

}  // namespace

PictureHeader jpeg_header(Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  Reader reader;
  open(reader, bytes, where, limits);
  return {.width = static_cast<int>(reader.info.image_width),
          .height = static_cast<int>(reader.info.image_height),
          .channels = reader.info.num_components,
          .bits = 8,
          .many_passes = coefficient_bytes(reader) > 0,
          .jpeg = true};
}

Image8 decode_jpeg(Bytes bytes, const std::string& where, const DecodeLimits& limits, const Shrink& shrink) {
  Reader reader;
  open(reader, bytes, where, limits);
  const int width = static_cast<int>(reader.info.image_width);
  const int height = static_cast<int>(reader.info.image_height);
  if (const std::uint64_t needed = coefficient_bytes(reader); needed > max_coefficient_bytes)
    throw input_error(where, "JPEG is progressive, {} x {} pixels: reading it takes {} MB, the limit is {}",
                      width, height, needed / 1'000'000, max_coefficient_bytes / 1'000'000);

  Shrinking picture(width, height, shrink);
  std::vector<unsigned char> row(static_cast<std::size_t>(width) * 4);
  if (!read_pixels(reader, row.data(), picture)) refuse(reader, where);
  if (reader.warning[0] != 0) warn("{}: {}", where, reader.warning);
  return picture.take();
}

}  // namespace dermis::image::formats
