// SPDX-License-Identifier: MIT
// Based on: the OpenEXR file layout, openexr.com, "OpenEXR File Layout" (version 2 files).
#include "image/files/exr_header.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>

#include "base/core/error.h"

namespace dermis::image::formats {

namespace {

constexpr std::uint64_t max_buffer_bytes = std::uint64_t{1} << 29;  // that the library may hold for one chunk
// A cropped picture has black pixels around its data, which take memory but no bytes of the file. Any file
// may have `free_display_pixels` of them, and beyond that `display_per_data_pixel` per pixel of data.
constexpr std::uint64_t free_display_pixels = std::uint64_t{1} << 24, display_per_data_pixel = 16;
constexpr std::size_t max_channels = 1024;
constexpr std::size_t max_parts = 1024;
constexpr std::uint32_t flag_tiled = 0x200, flag_deep = 0x800, flag_many_parts = 0x1000;

/// Reads little-endian values; throws InputError past the end.
class Input {
 public:
  Input(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}

  std::size_t left() const { return bytes_.size(); }
  std::string_view take(std::size_t count) {
    if (count > bytes_.size())
      throw input_error(where_, "EXR is truncated or damaged: its header does not end");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  std::uint32_t u32() {
    const std::string_view b = take(4);
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<std::uint8_t>(b[i]);
    return value;
  }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  std::uint8_t u8() { return static_cast<std::uint8_t>(take(1)[0]); }
  /// Reads up to the next zero byte.
  std::string_view text() {
    const std::size_t end = bytes_.substr(0, 256).find('\0');
    const std::string_view taken = take(end == std::string_view::npos ? bytes_.size() + 1 : end);
    take(1);
    return taken;
  }

 private:
  std::string_view bytes_;
  const std::string& where_;
};

struct Box {
  std::int64_t width = 0;
  std::int64_t height = 0;
};

/// Returns the pixels of a box that check_size() has accepted.
std::uint64_t pixels_of(const Box& box) {
  return static_cast<std::uint64_t>(box.width) * static_cast<std::uint64_t>(box.height);
}

struct Part {
  std::optional<Box> data_window;
  std::optional<Box> display_window;
  std::optional<Box> tile;
  std::optional<std::uint8_t> compression;
  std::uint64_t pixel_bytes = 0;  // all channels
  std::uint64_t chunk_count = 0;  // as declared; 0 if not declared
};

Box read_box(Input& input) {
  const std::int64_t x0 = input.i32(), y0 = input.i32(), x1 = input.i32(), y1 = input.i32();
  return {x1 - x0 + 1, y1 - y0 + 1};
}

std::uint64_t read_channels(Input& input, const std::string& where) {
  std::uint64_t bytes = 0;
  for (std::size_t count = 0; input.left() > 1; ++count) {
    if (count == max_channels) throw input_error(where, "EXR has more than {} channels", max_channels);
    input.text();
    bytes += input.u32() == 1 ? 2 : 4;  // half, else float or unsigned
    input.take(12);                     // linearity, reserved, two sampling rates
  }
  return bytes;
}

void read_attribute(Part& part, std::string_view name, std::string_view type, Input value,
                    const std::string& where) {
  if (name == "dataWindow") part.data_window = read_box(value);
  if (name == "displayWindow") part.display_window = read_box(value);
  if (name == "channels") part.pixel_bytes = read_channels(value, where);
  if (name == "compression") part.compression = value.u8();
  if (name == "chunkCount") part.chunk_count = value.u32();

  if (name == "tiles") {
    const std::int64_t width = value.u32();
    part.tile = Box{width, value.u32()};
  }

  if (name == "type" && value.take(value.left()).starts_with("deep"))
    throw input_error(where, "EXR holds a deep picture, expected a flat one");

  if (type == "preview") {
    const std::uint64_t width = value.u32();
    const std::uint64_t height = value.u32();
    if (width > 4096 || height > 4096 || width * height * 4 != value.left())
      throw input_error(where, "EXR is damaged: its preview has the wrong size");
  }
}

/// Reads one header, up to the empty name that ends it; returns nothing if it is empty (the end of a list of
/// parts).
std::optional<Part> read_part(Input& input, const std::string& where) {
  std::string_view name = input.text();
  if (name.empty()) return std::nullopt;
  Part part;
  for (; !name.empty(); name = input.text()) {
    const std::string_view type = input.text();
    const std::int32_t size = input.i32();
    if (size < 0)
      throw input_error(where, "EXR is damaged: its attribute '{}' has a negative size", printable(name));
    read_attribute(part, name, type, Input(input.take(static_cast<std::size_t>(size)), where), where);
  }
  return part;
}

// By compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
constexpr std::int64_t lines_per_chunk[] = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
// The most bytes that one byte of the file can become. The bounds of PIZ and DWA are ten times what a black
// picture of 4096 x 4096 pixels reaches (400 and 6,000); the others follow from the method.
constexpr std::uint64_t best_ratio[] = {1, 64, 1032, 1032, 4096, 1032 * 4 / 3 + 1, 64, 64, 65536, 65536};

void check_part(const Part& part, bool tiled, Bytes file, const std::string& where,
                const DecodeLimits& limits) {
  if (!part.data_window || !part.display_window || !part.compression || part.pixel_bytes == 0) {
    throw input_error(where, "EXR is damaged: its header lacks a window, the channels or the compression");
  }
  const Box& data = *part.data_window;
  check_size(data.width, data.height, limits, where);
  check_size(part.display_window->width, part.display_window->height, limits, where);
  const std::uint64_t data_pixels = pixels_of(data), display_pixels = pixels_of(*part.display_window);
  if (display_pixels > std::max(free_display_pixels, display_per_data_pixel * data_pixels))
    throw input_error(where, "EXR has a display window of {} x {} pixels for data of {} x {}",
                      part.display_window->width, part.display_window->height, data.width, data.height);
  if (*part.compression >= std::size(lines_per_chunk))
    throw input_error(where, "EXR has an unknown compression ({})", *part.compression);

  Box chunk{data.width, lines_per_chunk[*part.compression]};
  if (tiled) {
    if (!part.tile) throw input_error(where, "EXR is damaged: it is tiled and lacks the size of its tiles");
    chunk = *part.tile;
    check_size(chunk.width, chunk.height, limits, where);
  }
  // A tiled file is read as rows, for which the library keeps one row of tiles.
  const std::uint64_t row_width = static_cast<std::uint64_t>(std::max(chunk.width, data.width));
  const std::uint64_t buffer_bytes = row_width * static_cast<std::uint64_t>(chunk.height) * part.pixel_bytes;
  if (buffer_bytes > max_buffer_bytes)
    throw input_error(where, "EXR needs {} bytes for one chunk of its rows, the limit is {}", buffer_bytes,
                      max_buffer_bytes);

  const std::int64_t across = (data.width + chunk.width - 1) / chunk.width;
  const std::int64_t down = (data.height + chunk.height - 1) / chunk.height;
  // Each chunk has an entry of 8 bytes in the table and a header of at least 8.
  const std::uint64_t chunks = std::max(static_cast<std::uint64_t>(across * down), part.chunk_count);
  check_plausible(file, chunks * 16, data.width, data.height, where);
  // At least one channel has all pixels, with at least two bytes each.
  check_plausible(file, data_pixels * 2 / best_ratio[*part.compression], data.width, data.height, where);
}

}  // namespace

void check_exr_header(Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  Input input(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), where);
  input.take(4);  // magic
  const std::uint32_t version = input.u32();
  if ((version & 0xff) != 2) throw input_error(where, "EXR has version {}, expected 2", version & 0xff);
  if ((version & flag_deep) != 0) throw input_error(where, "EXR holds a deep picture, expected a flat one");
  const bool many = (version & flag_many_parts) != 0;
  std::size_t parts = 0;
  while (const std::optional<Part> part = read_part(input, where)) {
    if (++parts > max_parts) throw input_error(where, "EXR has more than {} parts", max_parts);
    check_part(*part, many ? part->tile.has_value() : (version & flag_tiled) != 0, bytes, where, limits);
    if (!many) break;
  }
  if (parts == 0) throw input_error(where, "EXR is damaged: its header is empty");
}

}  // namespace dermis::image::formats
