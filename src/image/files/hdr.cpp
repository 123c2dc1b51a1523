// SPDX-License-Identifier: MIT
// Radiance pictures (.hdr): a text header, then rows of RGBE pixels, plain or run-length coded in the old or
// the new way.
// Based on: Ward: Real Pixels. Graphics Gems II, 1991; the format description of Radiance (doc/filefmts,
//           "Picture File Format")
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/core/error.h"
#include "base/core/log.h"
#include "image/files/formats.h"

namespace dermis::image::formats {

namespace {

using std::size_t;
using Rgbe = std::uint8_t[4];

constexpr size_t max_header_bytes = size_t{1} << 16;

/// Reads bytes; throws InputError past the end.
class HdrInput {
 public:
  HdrInput(Bytes bytes, const std::string& where) : bytes_(bytes), where_(where) {}

  size_t left() const { return bytes_.size() - at_; }
  std::uint8_t byte() {
    if (left() == 0) throw input_error(where_, "HDR is truncated");
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  std::string_view line() {
    const std::string_view rest(reinterpret_cast<const char*>(bytes_.data()) + at_,
                                std::min(left(), max_header_bytes));
    const size_t end = rest.find('\n');
    if (end == std::string_view::npos || at_ > max_header_bytes)
      throw input_error(where_, "HDR is truncated or damaged: no end of its header");
    at_ += end + 1;
    return rest.substr(0, end);
  }

 private:
  Bytes bytes_;
  const std::string& where_;
  size_t at_ = 0;
};

struct Layout {
  std::int64_t width = 0;
  std::int64_t height = 0;
  bool bottom_up = false;
  bool right_to_left = false;
};

std::string_view word(std::string_view& text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\r')) text.remove_prefix(1);
  const std::string_view first = text.substr(0, text.find_first_of(" \r"));
  text.remove_prefix(first.size());
  return first;
}

// Parses "-Y 512 +X 1024": rows from the top, pixels from the left. Other signs mirror; a leading X would
// mean columns and is rejected.
Layout parse_resolution(std::string_view line, const std::string& where) {
  std::string_view rest = line;
  const auto number = [&](std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      throw input_error(where, "HDR is damaged: its size must read like \"-Y 512 +X 1024\", got \"{}\"",
                        printable(line.substr(0, 80)));
    }
    return value;
  };

  const std::string_view first = word(rest);
  if (first == "+X" || first == "-X")
    throw input_error(where, "HDR stores columns (\"{}\"), expected rows (\"-Y ... +X ...\")",
                      printable(line.substr(0, 80)));

  Layout layout;
  layout.bottom_up = first == "+Y";
  layout.height = number(word(rest));
  const std::string_view second = word(rest);
  layout.right_to_left = second == "-X";
  layout.width = number(word(rest));

  const bool known =
      (first == "-Y" || first == "+Y") && (second == "+X" || second == "-X") && word(rest).empty();
  if (!known) number(line);  // throws with the whole line
  return layout;
}

Layout read_header(HdrInput& input, const std::string& where) {
  input.line();  // "#?RADIANCE" or "#?RGBE": recognised already
  std::string_view line;
  while (!(line = input.line()).empty() && line != "\r") {
    constexpr std::string_view format_key = "FORMAT=";
    if (line.starts_with("EXPOSURE="))
      note("{}: {} is not applied, as in other renderers", where, printable(line.substr(0, 40)));
    if (!line.starts_with(format_key)) continue;
    line.remove_prefix(format_key.size());
    const std::string_view format = word(line);
    if (format != "32-bit_rle_rgbe")
      throw input_error(where, "HDR has the format \"{}\", expected 32-bit_rle_rgbe",
                        printable(format.substr(0, 40)));
  }
  return parse_resolution(input.line(), where);
}

// Reads the old coding: four bytes per pixel. (1, 1, 1, n) repeats the previous pixel n times; further such
// pixels count in steps of 256.
void read_old_row(HdrInput& input, const Rgbe& first, std::vector<std::uint8_t>& row, size_t width,
                  const std::string& where) {
  size_t x = 0;
  unsigned shift = 0;
  Rgbe pixel = {first[0], first[1], first[2], first[3]};

  for (bool have = true; x < width; have = false) {
    if (!have) {
      for (std::uint8_t& b : pixel) b = input.byte();
    }

    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      for (size_t c = 0; c < 4; ++c) row[x * 4 + c] = pixel[c];
      ++x;
      shift = 0;
      continue;
    }

    const size_t run = shift > 24 ? width + 1 : static_cast<size_t>(pixel[3]) << shift;
    if (x == 0 || run > width - x) throw input_error(where, "HDR is damaged: a run of pixels leaves its row");
    for (size_t i = 0; i < run * 4; ++i) row[x * 4 + i] = row[x * 4 + i - 4];
    x += run;
    shift += 8;
  }
}

// Reads the new coding: the four components one after the other, each as runs (length > 128) and copies.
void read_new_row(HdrInput& input, std::vector<std::uint8_t>& row, size_t width, const std::string& where) {
  for (size_t c = 0; c < 4; ++c) {
    for (size_t x = 0; x < width;) {
      const size_t code = input.byte();
      const bool run = code > 128;
      const size_t count = run ? code - 128 : code;
      if (count == 0 || count > width - x)
        throw input_error(where, "HDR is damaged: a run of pixels leaves its row");
      std::uint8_t value = run ? input.byte() : std::uint8_t{0};
      for (size_t i = 0; i < count; ++i, ++x) {
        if (!run) value = input.byte();
        row[x * 4 + c] = value;
      }
    }
  }
}

void read_row(HdrInput& input, std::vector<std::uint8_t>& row, size_t width, const std::string& where) {
  Rgbe first;
  for (std::uint8_t& b : first) b = input.byte();
  const bool new_coding = width >= 8 && width <= 0x7fff && first[0] == 2 && first[1] == 2 && first[2] < 128;
  if (!new_coding) return read_old_row(input, first, row, width, where);
  const size_t declared = static_cast<size_t>(first[2]) << 8 | first[3];
  if (declared != width)
    throw input_error(where, "HDR is damaged: a row of {} pixels in a picture {} wide", declared, width);
  read_new_row(input, row, width, where);
}

// Ward's reader adds 0.5 to each mantissa. Other readers, and the writers of today's environments, do not;
// nor do we.
void to_float(const std::uint8_t* rgbe, float* rgb) {
  const float scale = rgbe[3] == 0 ? 0.0f : std::ldexp(1.0f, rgbe[3] - (128 + 8));
  for (int c = 0; c < 3; ++c) rgb[c] = static_cast<float>(rgbe[c]) * scale;
}

}  // namespace

ImageF decode_hdr(Bytes bytes, const std::string& where, const DecodeLimits& limits,
                  std::uint64_t most_pixels) {
  HdrInput input(bytes, where);
  const Layout layout = read_header(input, where);
  check_size(layout.width, layout.height, limits, where);
  // The shortest row is one pixel and one long run of the old coding.
  check_plausible(bytes, static_cast<std::uint64_t>(layout.height) * (layout.width == 1 ? 4 : 8),
                  layout.width, layout.height, where);

  const int height = static_cast<int>(layout.height);
  const size_t width = static_cast<size_t>(layout.width);
  Collected picture(static_cast<int>(layout.width), height, most_pixels);
  std::vector<std::uint8_t> row(width * 4);
  std::vector<float> rgb(width * 3);

  for (int i = 0; i < height; ++i) {
    read_row(input, row, width, where);
    for (size_t x = 0; x < width; ++x)
      to_float(&row[x * 4], &rgb[3 * (layout.right_to_left ? width - 1 - x : x)]);
    picture.row(layout.bottom_up ? height - 1 - i : i, rgb);
  }

  return picture.take(where);
}

}  // namespace dermis::image::formats
