// SPDX-License-Identifier: MIT
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "base/core/error.h"
#include "dermis/cancelled.h"
#include "image/files/exr_header.h"
#include "image/files/formats.h"

namespace dermis::image::formats {

namespace {

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(Bytes bytes) : IStream("EXR"), bytes_(bytes) {}

  bool read(char out[], int count) override {
    if (count < 0 || static_cast<std::uint64_t>(count) > bytes_.size() - at_)
      throw std::runtime_error("it ends early");
    std::memcpy(out, bytes_.data() + at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override {
    if (at > bytes_.size()) throw std::runtime_error("it refers to data past its end");
    at_ = static_cast<std::size_t>(at);
  }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

enum class Colours { rgb, grey };

Colours choose_channels(const Imf::ChannelList& channels, const std::string& where) {
  std::string names;
  for (auto i = channels.begin(); i != channels.end(); ++i)
    names += (names.empty() ? "" : ", ") + std::string(i.name());
  const auto full = [&](const char* name) {
    const Imf::Channel* channel = channels.findChannel(name);
    return channel != nullptr && channel->xSampling == 1 && channel->ySampling == 1;
  };
  if (full("R") && full("G") && full("B")) return Colours::rgb;
  // With RY and BY, Y is the luminance of a coloured picture.
  if (full("Y") && channels.findChannel("RY") == nullptr && channels.findChannel("BY") == nullptr)
    return Colours::grey;
  throw input_error(where,
                    "EXR has the channels {}; expected R, G and B, or Y, at full size in its first part",
                    printable(names));
}

/// Reads rows y0 to y1 of the data window: three floats per pixel into `values`.
void read_rows(Imf::InputFile& file, Colours colours, int y0, int y1, std::vector<float>& values) {
  Imath::Box2i window = file.header().dataWindow();
  window.min.y = y0;
  window.max.y = y1;

  const std::size_t width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  values.resize(width * static_cast<std::size_t>(y1 - y0 + 1) * 3);
  const std::size_t pixel = 3 * sizeof(float);

  Imf::FrameBuffer target;
  const auto add = [&](const char* name, std::size_t channel) {
    target.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data() + channel, window, pixel, pixel * width));
  };
  if (colours == Colours::grey) {
    add("Y", 0);
  } else {
    add("R", 0);
    add("G", 1);
    add("B", 2);
  }

  file.setFrameBuffer(target);
  file.readPixels(y0, y1);
  if (colours == Colours::grey) {
    for (std::size_t i = 0; i < values.size(); i += 3) values[i + 1] = values[i + 2] = values[i];
  }
}

/// Reads the display window in strips of rows; black where it has no data.
ImageF read_display_window(Imf::InputFile& file, Colours colours, std::uint64_t most_pixels,
                           const std::string& where) {
  constexpr int strip_rows = 256;  // the most rows that any compression packs together
  const Imath::Box2i data = file.header().dataWindow(), display = file.header().displayWindow();
  const int x0 = std::max(data.min.x, display.min.x), x1 = std::min(data.max.x, display.max.x);
  const int y0 = std::max(data.min.y, display.min.y), y1 = std::min(data.max.y, display.max.y);
  if (x0 > x1 || y0 > y1) throw input_error(where, "EXR has no pixel inside its display window");

  const int width = display.max.x - display.min.x + 1, height = display.max.y - display.min.y + 1;
  Collected picture(width, height, most_pixels);
  const std::size_t data_width = static_cast<std::size_t>(data.max.x - data.min.x + 1);
  std::vector<float> strip, row(static_cast<std::size_t>(width) * 3);
  for (int y = display.min.y; y <= display.max.y; ++y) {
    if (y < y0 || y > y1) {
      std::ranges::fill(row, 0.0f);
    } else {
      // Strips begin where the strips of the file do.
      const int in_strip = (y - data.min.y) % strip_rows;
      const int first = std::max(y - in_strip, y0);
      if (in_strip == 0 || y == y0)
        read_rows(file, colours, first, std::min(y - in_strip + strip_rows - 1, y1), strip);
      const std::size_t from =
          static_cast<std::size_t>(y - first) * data_width + static_cast<std::size_t>(x0 - data.min.x);
      std::copy_n(strip.data() + from * 3, static_cast<std::size_t>(x1 - x0 + 1) * 3,
                  row.data() + static_cast<std::size_t>(x0 - display.min.x) * 3);
    }
    picture.row(y - display.min.y, row);
  }
  return picture.take(where);
}

}  // namespace

ImageF decode_exr(Bytes bytes, const std::string& where, const DecodeLimits& limits,
                  std::uint64_t most_pixels) {
  check_exr_header(bytes, where, limits);
  try {
    MemoryInput stream(bytes);
    Imf::InputFile file(stream, 0);
    const Colours colours = choose_channels(file.header().channels(), where);
    if (!file.isComplete()) throw input_error(where, "EXR is truncated");
    return read_display_window(file, colours, most_pixels, where);
  } catch (const InputError&) { throw; } catch (const InternalError&) {
    throw;
  } catch (const Cancelled&) { throw; } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw input_error(where, "EXR is truncated or damaged: {}", printable(error.what()));
  }
}

}  // namespace dermis::image::formats
