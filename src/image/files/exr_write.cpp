// SPDX-License-Identifier: MIT
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

#include "base/core/error.h"
#include "image/colour.h"
#include "image/files/formats.h"
#include "image/layers.h"

namespace dermis::image::formats {

namespace {

class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : OStream("EXR") {}

  void write(const char in[], int count) override {
    const std::size_t end = at_ + static_cast<std::size_t>(count);
    if (end > bytes_.size()) bytes_.resize(end);
    std::memcpy(bytes_.data() + at_, in, static_cast<std::size_t>(count));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = static_cast<std::size_t>(at); }
  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

// Keeps bright finite values finite: an infinite one would be read back as black.
std::uint16_t finite_half(float value) {
  return float_to_half(std::isfinite(value) ? std::clamp(value, -max_half, max_half) : value);
}

void write(MemoryOutput& stream, const ImageF& picture, Imf::PixelType type, const void* pixels,
           std::size_t value_bytes) {
  constexpr const char* names[] = {"R", "G", "B", "A"};
  Imf::Header header(picture.width, picture.height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y,
                     Imf::ZIP_COMPRESSION);
  Imf::addChromaticities(header, Imf::Chromaticities());  // those of Rec. 709, which are sRGB's
  Imf::FrameBuffer source;
  const std::size_t channels = static_cast<std::size_t>(picture.channels);
  const std::size_t pixel_bytes = channels * value_bytes;
  for (std::size_t c = 0; c < channels; ++c) {
    header.channels().insert(names[c], Imf::Channel(type));
    // The library uses one type for reading and writing; here it only reads.
    char* first = static_cast<char*>(const_cast<void*>(pixels)) + c * value_bytes;
    source.insert(names[c], Imf::Slice(type, first, pixel_bytes,
                                       pixel_bytes * static_cast<std::size_t>(picture.width)));
  }
  Imf::OutputFile file(stream, header, 0);
  file.setFrameBuffer(source);
  file.writePixels(picture.height);
}

// Errors of the library become errors that name the file.
template <class Write>
std::vector<std::byte> encoded(const std::string& where, const Write& write) {
  MemoryOutput stream;
  try {
    write(stream);
  } catch (const InternalError&) { throw; } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw input_error(where, "cannot be encoded as OpenEXR: {}", error.what());
  }
  return stream.take();
}

}  // namespace

std::vector<std::byte> encode_exr(const ImageF& picture, bool half_float, const std::string& where) {
  return encoded(where, [&](MemoryOutput& stream) {
    if (half_float) {
      std::vector<std::uint16_t> halves(picture.values.size());
      std::transform(picture.values.begin(), picture.values.end(), halves.begin(), finite_half);
      write(stream, picture, Imf::HALF, halves.data(), sizeof(std::uint16_t));
    } else {
      write(stream, picture, Imf::FLOAT, picture.values.data(), sizeof(float));
    }
  });
}

}  // namespace dermis::image::formats

namespace dermis::image {

std::vector<std::byte> encode_layers(int width, int height, std::span<const LayerChannel> channels,
                                     const std::string& where) {
  return formats::encoded(where, [&](formats::MemoryOutput& stream) {
    Imf::Header header(width, height, 1, Imath::V2f(0, 0), 1, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
    Imf::addChromaticities(header, Imf::Chromaticities());
    Imf::FrameBuffer source;
    for (const LayerChannel& channel : channels) {
      const Imf::PixelType type = channel.whole ? Imf::UINT : Imf::FLOAT;
      header.channels().insert(channel.name, Imf::Channel(type));
      // The library uses one type for reading and writing; here it only reads.
      char* first = reinterpret_cast<char*>(const_cast<std::byte*>(channel.first));
      source.insert(channel.name, Imf::Slice(type, first, channel.pixel_bytes,
                                             channel.pixel_bytes * static_cast<std::size_t>(width)));
    }
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(source);
    file.writePixels(height);
  });
}

}  // namespace dermis::image
