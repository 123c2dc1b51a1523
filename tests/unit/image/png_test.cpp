// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>

#include "image/files/formats.h"
#include "pictures.h"

namespace dermis::image::test {
namespace {

using Pixels = std::vector<std::uint8_t>;

Pixels spread(const Pixels& samples, int per_pixel) {
  Pixels rgba;
  for (std::size_t i = 0; i < samples.size(); i += static_cast<std::size_t>(per_pixel)) {
    const std::uint8_t* p = &samples[i];
    const bool grey = per_pixel < 3;
    const std::uint8_t alpha = per_pixel == 2 ? p[1] : (per_pixel == 4 ? p[3] : std::uint8_t{255});
    rgba.insert(rgba.end(), {p[0], p[grey ? 0 : 1], p[grey ? 0 : 2], alpha});
  }
  return rgba;
}

TEST(Png, AllEightBitKindsPlainAndInterlaced) {
  // colour type, samples per pixel
  const std::pair<std::uint8_t, int> kinds[] = {{0, 1}, {2, 3}, {4, 2}, {6, 4}};

  for (const auto& [colour_type, per_pixel] : kinds) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 37u}, {53u, 1u}, {29u, 31u}}) {
      for (const bool interlaced : {false, true}) {
        const Pixels samples =
            noise(width * height * static_cast<unsigned>(per_pixel), width + height + colour_type);
        const Bytes file = make_png({.width = width,
                                     .height = height,
                                     .bit_depth = 8,
                                     .colour_type = colour_type,
                                     .interlaced = interlaced,
                                     .palette_rgba = {}},
                                    samples);

        const Image8 picture = decode_image8(file, "map");
        EXPECT_EQ(picture.width, static_cast<int>(width));
        EXPECT_EQ(picture.height, static_cast<int>(height));
        EXPECT_EQ(picture.rgba, spread(samples, per_pixel))
            << "type " << int{colour_type} << " interlaced " << interlaced;
      }
    }
  }
}

// All 65536 values: the stored 8 bits are the nearest of 255 steps, not the high byte.
TEST(Png, SixteenBitsAreRounded) {
  std::vector<std::uint16_t> grey(65536);
  for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = static_cast<std::uint16_t>(i);
  Pixels samples(grey.size() * 2);
  std::memcpy(samples.data(), grey.data(), samples.size());
  const Image8 picture = decode_image8(
      make_png({.width = 256, .height = 256, .bit_depth = 16, .colour_type = 0, .palette_rgba = {}}, samples),
      "map");
  for (std::size_t i = 0; i < grey.size(); ++i) {
    const int nearest = static_cast<int>(static_cast<double>(i) / 257.0 + 0.5);
    ASSERT_EQ(picture.rgba[i * 4], nearest) << i;
    ASSERT_EQ(picture.rgba[i * 4 + 3], 255);
  }
}

TEST(Png, SixteenBitRgba) {
  // 128/257 is just below half a step, 129/257 just above
  const std::uint16_t pixel[] = {0, 128, 129, 65535};
  Pixels samples(sizeof pixel);
  std::memcpy(samples.data(), pixel, sizeof pixel);
  EXPECT_EQ(decode_image8(make_png({.bit_depth = 16, .palette_rgba = {}}, samples), "map").rgba,
            (Pixels{0, 0, 1, 255}));
}

TEST(Png, SmallDepthsAndPalette) {
  const Pixels bits = {0b10100000};  // 1 0 1
  EXPECT_EQ(
      decode_image8(make_png({.width = 3, .bit_depth = 1, .colour_type = 0, .palette_rgba = {}}, bits), "map")
          .rgba,
      (Pixels{255, 255, 255, 255, 0, 0, 0, 255, 255, 255, 255, 255}));

  const Pixels pairs = {0b00011011};  // 0 1 2 3
  const Pixels palette = {10, 20, 30, 255, 40, 50, 60, 128, 70, 80, 90, 0, 1, 2, 3, 4};
  EXPECT_EQ(
      decode_image8(make_png({.width = 4, .bit_depth = 2, .colour_type = 3, .palette_rgba = palette}, pairs),
                    "map")
          .rgba,
      palette);

  const Pixels key = {7, 8};
  EXPECT_EQ(
      decode_image8(make_png({.width = 2, .colour_type = 0, .palette_rgba = {}, .transparent_grey = 8}, key),
                    "map")
          .rgba,
      (Pixels{7, 7, 7, 255, 8, 8, 8, 0}));
}

TEST(Png, PaletteIndexOutOfRangeIsBlack) {
  const Pixels indices = {0, 1, 2, 255};
  EXPECT_EQ(decode_image8(
                make_png({.width = 4, .colour_type = 3, .palette_rgba = {1, 2, 3, 255, 4, 5, 6, 7}}, indices),
                "map")
                .rgba,
            (Pixels{1, 2, 3, 255, 4, 5, 6, 7, 0, 0, 0, 255, 0, 0, 0, 255}));
}

TEST(Png, OurWriterRoundTripsAndIsDeterministic) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 64}, {200, 3}, {65, 63}}) {
    Image8 picture{
        .width = width, .height = height, .rgba = noise(static_cast<std::size_t>(width * height) * 4, 5)};
    const Bytes kept = formats::encode_png(picture, true, "out");
    const Bytes fast = formats::encode_png(picture, true, "out", PngEffort::fast);
    EXPECT_EQ(formats::decode_png(fast, "fast", {}, {}).rgba, picture.rgba);
    EXPECT_EQ(decode_image8(kept, "out").rgba, picture.rgba);
    EXPECT_EQ(formats::encode_png(picture, true, "out"), kept);
    const Bytes opaque = formats::encode_png(picture, false, "out");
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    EXPECT_EQ(decode_image8(opaque, "out").rgba, picture.rgba);
    EXPECT_EQ(formats::encode_png(picture, false, "out"), opaque)
        << "the alpha that is dropped must not matter";
  }
}

TEST(Png, OurFilesHoldPixelsAndWhatTheirColoursAre) {
  const Image8 picture{.width = 2, .height = 1, .rgba = {1, 2, 3, 4, 5, 6, 7, 8}};
  const Bytes file = formats::encode_png(picture, false, "out");
  std::string chunks;
  for (std::size_t at = 8; at + 8 <= file.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<std::size_t>(file[at + i]);
    chunks += std::string(reinterpret_cast<const char*>(&file[at + 4]), 4) + " ";
    at += length + 12;
  }
  EXPECT_EQ(chunks, "IHDR sRGB IDAT IEND ");
}

}  // namespace
}  // namespace dermis::image::test
