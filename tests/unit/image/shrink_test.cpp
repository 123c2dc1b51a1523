// SPDX-License-Identifier: MIT
// Pictures that are made smaller while they are read, against averages over areas in double.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "image/colour.h"
#include "image/files/formats.h"
#include "mip_chain.h"
#include "pictures.h"
#include "support/log_lines.h"

namespace dermis::image::test {
namespace {

constexpr std::uint64_t any = ~std::uint64_t{0};

/// How much of pixel `i` of `source` lies in pixel `t` of `target`, over the size of the latter.
double share(int i, int source, int t, int target) {
  const double scale = static_cast<double>(source) / target;
  return std::max(0.0, std::min(i + 1.0, (t + 1) * scale) - std::max<double>(i, t * scale)) / scale;
}

/// Opaque pictures: the mean of linear light, or of values.
std::vector<std::uint8_t> averaged(const Image8& large, int width, int height, bool srgb) {
  std::vector<std::uint8_t> out;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 4; ++c) {
        double sum = 0;
        for (int j = 0; j < large.height; ++j)
          for (int i = 0; i < large.width; ++i) {
            const std::uint8_t value = large.at(i, j)[c];
            const double linear = srgb && c < 3 ? static_cast<double>(srgb8_to_linear(value)) : value / 255.0;
            sum += share(i, large.width, x, width) * share(j, large.height, y, height) * linear;
          }
        out.push_back(srgb && c < 3 ? linear_to_srgb8(static_cast<float>(sum))
                                    : static_cast<std::uint8_t>(std::lround(255 * sum)));
      }
  return out;
}

void expect_within_one(const std::vector<std::uint8_t>& found, const std::vector<std::uint8_t>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1) << i;
}

TEST(Shrink, PngOfEveryKindIsTheAverageOfAreas) {
  constexpr int width = 37, height = 29;
  const std::vector<std::uint8_t> rgb = noise(width * height * 3, 5);
  std::vector<std::uint8_t> wide(rgb.size() * 2);
  for (std::size_t i = 0; i < rgb.size(); ++i) wide[2 * i] = wide[2 * i + 1] = rgb[i];  // times 257

  for (const bool interlaced : {false, true})
    for (const bool sixteen : {false, true}) {
      const Bytes file = make_png({.width = width,
                                   .height = height,
                                   .bit_depth = static_cast<std::uint8_t>(sixteen ? 16 : 8),
                                   .colour_type = 2,
                                   .interlaced = interlaced,
                                   .palette_rgba = {}},
                                  sixteen ? wide : rgb);

      const Image8 large = decode_image8(file, "map");
      for (const int halvings : {1, 2, 3, 9})
        for (const bool srgb : {false, true}) {
          const Image8 small = decode_image8(file, "map", {}, {.halvings = halvings, .srgb = srgb});
          ASSERT_EQ(small.width, std::max(1, width >> halvings));
          ASSERT_EQ(small.height, std::max(1, height >> halvings));
          expect_within_one(small.rgba, averaged(large, small.width, small.height, srgb));
        }
    }
}

TEST(Shrink, SixteenBitsAreKeptWhereTheyAreAskedFor) {
  const std::vector<std::uint8_t> samples = noise(8 * 4 * 2, 5);  // grey, low byte first
  const Bytes file =
      make_png({.width = 8, .height = 4, .bit_depth = 16, .colour_type = 0, .palette_rgba = {}}, samples);
  const auto grey = [&](std::size_t i) { return samples[2 * i] + samples[2 * i + 1] * 256; };

  const Image8 whole = decode_image8(file, "map", {}, {.deep = true});
  EXPECT_EQ(whole.rgba, decode_image8(file, "map").rgba);
  EXPECT_TRUE(decode_image8(file, "map").rgba16.empty());
  ASSERT_EQ(whole.rgba16.size(), whole.rgba.size());
  for (std::size_t i = 0; i < 32; ++i) EXPECT_EQ(whole.rgba16[4 * i + 1], grey(i));
  EXPECT_FLOAT_EQ(whole.value(3, 2, 0), static_cast<float>(grey(19)) / 257);

  const Image8 half = decode_image8(file, "map", {}, {.halvings = 1, .deep = true});
  ASSERT_EQ(half.rgba16.size(), 4u * 2 * 4);
  EXPECT_NEAR(half.rgba16[0], (grey(0) + grey(1) + grey(8) + grey(9)) / 4.0, 1);
  EXPECT_NEAR(half.rgba16[4 * 7 + 2], (grey(22) + grey(23) + grey(30) + grey(31)) / 4.0, 1);

  const Bytes eight = make_png({.width = 4, .height = 2, .palette_rgba = {}}, noise(32, 1));
  EXPECT_TRUE(decode_image8(eight, "map", {}, {.deep = true}).rgba16.empty());
}

TEST(Shrink, JpegToo) {
  constexpr int width = 40, height = 24;
  for (const JpegKind kind : {JpegKind::rgb, JpegKind::progressive}) {
    const Bytes file = make_jpeg(width, height, kind, noise(width * height * 3, 9));
    const Image8 large = decode_image8(file, "map");
    const Image8 small = decode_image8(file, "map", {}, {.halvings = 2, .srgb = true});
    expect_within_one(small.rgba, averaged(large, 10, 6, true));
  }
}

// What alpha hides does not bleed in, as in the levels of a texture.
TEST(Shrink, ALevelOfTheTextureIsTheSamePicture) {
  const std::vector<std::uint8_t> rgba = noise(64 * 32 * 4, 3);
  const Bytes file = make_png({.width = 64, .height = 32, .palette_rgba = {}}, rgba);
  for (const bool srgb : {false, true}) {
    const std::vector<Image8> levels = mip_chain(decode_image8(file, "map"), srgb);
    for (const int k : {1, 2, 4})
      expect_within_one(decode_image8(file, "map", {}, {.halvings = k, .srgb = srgb}).rgba,
                        levels[static_cast<std::size_t>(k)].rgba);
  }
}

TEST(Shrink, HeadersTellSizesWithoutDecoding) {
  Bytes png = make_png(
      {.width = 30, .height = 20, .bit_depth = 16, .colour_type = 0, .interlaced = true, .palette_rgba = {}},
      noise(1200, 1));
  for (const bool cut : {false, true}) {
    if (cut) png.resize(png.size() - 100);
    const PictureHeader header = read_header8(png, "map");
    EXPECT_EQ(std::pair(header.width, header.height), std::pair(30, 20));
    EXPECT_EQ(std::pair(header.channels, header.bits), std::pair(1, 16));
    EXPECT_TRUE(header.many_passes);
    EXPECT_EQ(passing_bytes(header, {}), 0u) << "goes straight into the picture";
    EXPECT_EQ(passing_bytes(header, {.halvings = 1}), 30u * 20 / 4 * 16);
  }
  const PictureHeader jpeg = read_header8(make_jpeg(16, 8, JpegKind::progressive, noise(384, 1)), "map");
  EXPECT_EQ(std::pair(jpeg.width, jpeg.height), std::pair(16, 8));
  EXPECT_EQ(passing_bytes(jpeg, {}), 16u * 8 * 3 * 2);
  EXPECT_EQ(passing_bytes(read_header8(make_jpeg(16, 8, JpegKind::rgb, noise(384, 1)), "map"), {}), 0u);
}

// The library keeps every coefficient of a progressive picture: refused before they are taken.
TEST(Shrink, AProgressiveJpegOverOneGigabyteIsRefused) {
  Bytes file = make_jpeg(16, 8, JpegKind::progressive, noise(384, 1));
  bool patched = false;
  for (std::size_t i = 0; i + 9 < file.size() && !patched; ++i) {
    if (file[i] != std::byte{0xFF} || file[i + 1] != std::byte{0xC2}) continue;  // SOF2
    file[i + 5] = file[i + 7] = std::byte{0x40};                                 // 16384 x 16384
    file[i + 6] = file[i + 8] = std::byte{0};
    patched = true;
  }
  ASSERT_TRUE(patched);
  file.resize(600'000);
  EXPECT_NE(error_of8(file).find("is progressive, 16384 x 16384 pixels: reading it takes 1610 MB"),
            std::string::npos)
      << error_of8(file);
}

TEST(Shrink, LinearPicturesAreHalvedToTheLimit) {
  tests::LogLines said;
  std::vector<float> values;
  for (int i = 0; i < 20 * 12; ++i)
    values.insert(values.end(), {static_cast<float>(i % 20), static_cast<float>(i / 20), 1});
  values[0] = std::numeric_limits<float>::infinity();  // read as 65504 before it is averaged, not after
  for (const int tile : {0, 8}) {
    const ImageF small = decode_image_f(
        make_exr({.width = 20, .height = 12, .channels = "RGB", .tile = tile}, values), "sky", {}, 60);
    ASSERT_EQ(std::pair(small.width, small.height), std::pair(10, 6));
    EXPECT_NEAR(small.at(0, 0)[0], 16376.5, 1e-2) << "(65504 + 1 + 0 + 1) / 4";
    EXPECT_NEAR(small.at(0, 0)[2], 1, 1e-6);
    for (int y = 0; y < 6; ++y)
      for (int x = y == 0 ? 1 : 0; x < 10; ++x) {
        EXPECT_NEAR(small.at(x, y)[0], 2 * x + 0.5, 1e-5);
        EXPECT_NEAR(small.at(x, y)[1], 2 * y + 0.5, 1e-5);
      }
  }
  ASSERT_EQ(said.all.size(), 4u);
  EXPECT_EQ(said.all[0], "sky: 20 x 12 pixels, read as 10 x 6");

  // An .hdr of two rows of 1 and one of 3, from the top and from the bottom.
  const auto row = [](char mantissa) {
    std::string text;
    for (int x = 0; x < 4; ++x) text += {mantissa, mantissa, mantissa, char(-120)};  // mantissa * 2^0
    return text;
  };
  for (const bool bottom_up : {false, true}) {
    std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    text += bottom_up ? "+Y 3 +X 4\n" : "-Y 3 +X 4\n";
    text += row(8) + row(8) + row(24);
    const ImageF whole = decode_image_f(bytes_of(text), "sky", {}, any),
                 one = decode_image_f(bytes_of(text), "sky", {}, 2);
    EXPECT_EQ(whole.at(0, bottom_up ? 0 : 2)[0], 24);
    ASSERT_EQ(std::pair(one.width, one.height), std::pair(2, 1));
    EXPECT_NEAR(one.at(1, 0)[1], 40.0 / 3, 1e-5);
  }
}

}  // namespace
}  // namespace dermis::image::test
