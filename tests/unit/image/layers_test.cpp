// SPDX-License-Identifier: MIT
// Files of numbers: layers of an EXR, PNGs of 16 bits.
#include "image/layers.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string_view>

#include "image/codec.h"

namespace dermis::image {
namespace {

TEST(Layers, ColoursAreReadAsThoseOfAPicture) {
  const std::vector<float> rgb{0.5f, 1, 2, -1, 0.25f, 70000};
  const std::vector<std::uint32_t> ids{7, 0xffffffffu};
  std::vector<LayerChannel> channels{
      {.name = "part.id", .whole = true, .first = std::as_bytes(std::span(ids)).data()}};
  for (std::size_t c = 0; c < 3; ++c)
    channels.push_back({.name = std::string(1, "RGB"[c]),
                        .first = std::as_bytes(std::span(rgb)).data() + 4 * c,
                        .pixel_bytes = 12});
  const std::vector<std::byte> file = encode_layers(2, 1, channels, "x.exr");
  EXPECT_EQ(file, encode_layers(2, 1, channels, "x.exr")) << "no date";

  const ImageF read = decode_image_f(file, "x.exr");
  EXPECT_EQ(read.width, 2);
  ASSERT_EQ(read.channels, 3);
  EXPECT_EQ(read.values, rgb);
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  EXPECT_NE(text.find("part.id"), std::string_view::npos);
}

TEST(Png16, KeepsTheUpperByteOfEachValue) {
  const std::vector<std::uint16_t> grey{0, 0x1234, 0xffff, 0x80ff};
  const std::vector<std::byte> file = encode_png16(2, 2, 1, grey, "x.png");
  EXPECT_EQ(static_cast<int>(file[24]), 16) << "bits per value";
  const Image8 read = decode_image8(file, "x.png");
  for (std::size_t i = 0; i < grey.size(); ++i) EXPECT_NEAR(read.rgba[4 * i], grey[i] >> 8, 1) << i;

  const std::vector<std::uint16_t> rgb{0x0100, 0x8000, 0xff00};
  const Image8 colour = decode_image8(encode_png16(1, 1, 3, rgb, "x.png"), "x.png");
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(colour.rgba[c], rgb[c] >> 8, 1);
}

}  // namespace
}  // namespace dermis::image
