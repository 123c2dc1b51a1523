// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/colour.h"
#include "image/files/formats.h"
#include "pictures.h"
#include "support/log_lines.h"

namespace dermis::image::test {
namespace {

std::vector<float> values(std::size_t count) {
  std::vector<float> v;
  for (const std::uint8_t n : noise(count, 11)) v.push_back((static_cast<float>(n) - 20.0f) * 0.37f);
  return v;
}

ImageF picture(int width, int height, int channels) {
  return {.width = width,
          .height = height,
          .channels = channels,
          .values = values(static_cast<std::size_t>(width * height * channels))};
}

TEST(Exr, OurWriterRoundTripsFloat) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {70, 1}, {33, 35}}) {
    const ImageF in = picture(width, height, 3);
    const ImageF out = decode_image_f(formats::encode_exr(in, false, "out"), "out");
    EXPECT_EQ(out.width, width);
    EXPECT_EQ(out.height, height);
    EXPECT_EQ(out.values, in.values);
  }
}

TEST(Exr, OurWriterRoundsHalfToNearest) {
  ImageF in = picture(20, 10, 3);
  in.values[0] = 1e9f;  // stays finite
  in.values[1] = -1e9f;
  in.values[2] = 1.0f + 1.0f / 2048;  // a tie, to even
  const ImageF out = decode_image_f(formats::encode_exr(in, true, "out"), "out");
  EXPECT_EQ(out.values[0], max_half);
  EXPECT_EQ(out.values[1], -max_half);
  EXPECT_EQ(out.values[2], 1.0f);
  for (std::size_t i = 3; i < in.values.size(); ++i)
    EXPECT_EQ(out.values[i], half_to_float(float_to_half(in.values[i])));
}

TEST(Exr, AlphaIsWrittenAndColourComesBack) {
  const ImageF in = picture(5, 4, 4);
  const Bytes file = formats::encode_exr(in, false, "out");
  const ImageF out = decode_image_f(file, "out");
  ASSERT_EQ(out.channels, 3);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(out.at(x, y)[c], in.at(x, y)[c]);
    }
  }
  // The channel list: name, type 2 (float), linearity and reserved, sampling 1 and 1.
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  EXPECT_NE(text.find(std::string_view("A\0\2\0\0\0", 6)), std::string_view::npos);
}

TEST(Exr, BytesDependOnPixelsAloneAndCarryNoDate) {
  const ImageF in = picture(40, 30, 3);
  for (const bool half : {false, true}) {
    const Bytes file = formats::encode_exr(in, half, "out");
    EXPECT_EQ(formats::encode_exr(in, half, "elsewhere"), file);
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    for (const char* word : {"Date", "owner", "utcOffset", "software", "comments"})
      EXPECT_EQ(text.find(word), std::string_view::npos) << word;
  }
}

TEST(Exr, CompressionsAndTiles) {
  const ImageF in = picture(45, 70, 3);
  for (const int compression : {0, 1, 2, 3, 4}) {  // none, RLE, ZIPS, ZIP, PIZ: exact
    for (const int tile : {0, 16, 128}) {
      const ExrRecipe recipe{.width = 45, .height = 70, .compression = compression, .tile = tile};
      EXPECT_EQ(decode_image_f(make_exr(recipe, in.values), "sky").values, in.values)
          << compression << " tile " << tile;
    }
  }
}

TEST(Exr, GreySpreads) {
  const std::vector<float> grey = {1, 2, 3, 4};
  EXPECT_EQ(decode_image_f(make_exr({.width = 2, .height = 2, .channels = "Y"}, grey), "sky").values,
            (std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}));
}

TEST(Exr, MissingChannelsAreListed) {
  const std::vector<float> two(2, 1.0f);
  EXPECT_EQ(error_of_f(make_exr({.channels = "RG"}, two)),
            "sky: EXR has the channels G, R; expected R, G and B, or Y, at full size in its first part");
}

TEST(Exr, DataWindowIsCroppedToTheDisplayWindow) {
  const ImageF in = picture(6, 5, 3);
  // The data reaches from (-2, -1) to (3, 3); (0, 0) to (7, 3) is shown: 2 columns and 1 row are cut, the
  // rest is black.
  const ExrRecipe recipe{
      .x = -2, .y = -1, .width = 6, .height = 5, .show_x = 0, .show_y = 0, .show_width = 8, .show_height = 4};
  const ImageF out = decode_image_f(make_exr(recipe, in.values), "sky");
  ASSERT_EQ(out.width, 8);
  ASSERT_EQ(out.height, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      for (int c = 0; c < 3; ++c)
        EXPECT_EQ(out.at(x, y)[c], x < 4 ? in.at(x + 2, y + 1)[c] : 0.0f) << x << " " << y;
    }
  }
  const ExrRecipe apart{
      .x = 100, .y = 0, .width = 6, .height = 5, .show_x = 0, .show_y = 0, .show_width = 8, .show_height = 4};
  EXPECT_EQ(error_of_f(make_exr(apart, in.values)), "sky: EXR has no pixel inside its display window");
}

// The sun of a sky is often infinite: half floats end below it. As black the sky would lose its key light.
TEST(Exr, InfiniteLightIsTheBrightestWhatIsNoNumberIsNoneAndOneWarningSaysSo) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  ImageF in = picture(4, 4, 3);
  in.at(1, 0)[1] = std::numeric_limits<float>::quiet_NaN();
  in.at(2, 3)[0] = infinity;
  in.at(3, 3)[2] = -infinity;
  tests::LogLines said;
  const ImageF out = decode_image_f(formats::encode_exr(in, false, "out"), "sky");
  ASSERT_EQ(said.all.size(), 1u);
  EXPECT_EQ(said.all[0],
            "sky: 3 values are infinite or not numbers; infinite ones are read as 65504, others as 0");

  ImageF expected = in;
  expected.at(1, 0)[1] = 0;
  expected.at(2, 3)[0] = max_half;
  expected.at(3, 3)[2] = 0;
  EXPECT_EQ(out.values, expected.values);
}

}  // namespace
}  // namespace dermis::image::test
