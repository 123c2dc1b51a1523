// SPDX-License-Identifier: MIT
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "core/error.h"
#include "image/exr_header.h"
#include "image/formats.h"

namespace dermis::image::formats {

namespace {

class MemoryStream : public Imf::IStream {
 public:
  explicit MemoryStream(Bytes bytes) : IStream("EXR"), bytes_(bytes) {}

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
  // Y beside RY and BY is the brightness of a coloured picture.
  if (full("Y") && channels.findChannel("RY") == nullptr && channels.findChannel("BY") == nullptr)
    return Colours::grey;
  throw input_error(where,
                    "EXR has the channels {}; expected R, G and B, or Y, at full size in its first part",
                    printable(names));
}

/// The pixels of the data window, three floats each. Memory is touched as rows arrive: of a picture that is
/// much larger than its file, the first damaged rows end the reading.
std::vector<float> read_data_window(Imf::InputFile& file, Colours colours) {
  constexpr int rows_at_once = 256;  // the longest chunk of rows
  const Imath::Box2i window = file.header().dataWindow();
  const std::size_t width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
  const std::size_t height = static_cast<std::size_t>(window.max.y - window.min.y + 1);
  std::vector<float> values;
  values.reserve(width * height * 3);
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

  for (std::size_t row = 0; row < height; row += rows_at_once) {
    const std::size_t end = std::min(row + rows_at_once, height);
    values.resize(width * end * 3);
    const int first = window.min.y + static_cast<int>(row);
    file.readPixels(first, window.min.y + static_cast<int>(end) - 1);
  }

  if (colours == Colours::grey) {
    for (std::size_t i = 0; i < values.size(); i += 3) values[i + 1] = values[i + 2] = values[i];
  }
  return values;
}

ImageF crop_to_display(std::vector<float> values, const Imath::Box2i& data, const Imath::Box2i& display,
                       const std::string& where) {
  ImageF picture{.width = display.max.x - display.min.x + 1,
                 .height = display.max.y - display.min.y + 1,
                 .channels = 3,
                 .values = {}};
  if (data == display) {
    picture.values = std::move(values);
    return picture;
  }
  const int x0 = std::max(data.min.x, display.min.x), x1 = std::min(data.max.x, display.max.x);
  const int y0 = std::max(data.min.y, display.min.y), y1 = std::min(data.max.y, display.max.y);
  if (x0 > x1 || y0 > y1) throw input_error(where, "EXR has no pixel inside its display window");
  picture.values.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) *
                        3);
  const std::size_t data_width = static_cast<std::size_t>(data.max.x - data.min.x + 1);
  for (int y = y0; y <= y1; ++y) {
    const std::size_t from =
        static_cast<std::size_t>(y - data.min.y) * data_width + static_cast<std::size_t>(x0 - data.min.x);
    std::copy_n(values.data() + from * 3, static_cast<std::size_t>(x1 - x0 + 1) * 3,
                picture.at(x0 - display.min.x, y - display.min.y));
  }
  return picture;
}

}  // namespace

ImageF decode_exr(Bytes bytes, const std::string& where, const DecodeLimits& limits) {
  check_exr_header(bytes, where, limits);
  try {
    MemoryStream stream(bytes);
    Imf::InputFile file(stream, 0);
    const Colours colours = choose_channels(file.header().channels(), where);
    if (!file.isComplete()) throw input_error(where, "EXR is truncated");
    return crop_to_display(read_data_window(file, colours), file.header().dataWindow(),
                           file.header().displayWindow(), where);
  } catch (const InputError&) { throw; } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw input_error(where, "EXR is truncated or damaged: {}", printable(error.what()));
  }
}

}  // namespace dermis::image::formats
