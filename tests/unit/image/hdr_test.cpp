// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pictures.h"
#include "support/log_lines.h"

namespace dermis::image::test {
namespace {

std::string header(int width, int height, const std::string& axes = "-Y {} +X {}") {
  return "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n\n" +
         fmt::format(fmt::runtime(axes), height, width) + "\n";
}

std::string pixel(int r, int g, int b, int e) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

ImageF decode(const std::string& text) { return decode_image_f(bytes_of(text), "sky"); }
std::string error_of(const std::string& text) { return error_of_f(bytes_of(text)); }

std::vector<float> rgb(const ImageF& picture, int x, int y) {
  return {picture.at(x, y), picture.at(x, y) + 3};
}

TEST(Hdr, FlatPixelsAndExponents) {
  const ImageF picture = decode(header(4, 1) + pixel(128, 64, 32, 129) + pixel(255, 0, 1, 136) +
                                pixel(7, 8, 9, 0) + pixel(255, 128, 1, 255));
  EXPECT_EQ(picture.channels, 3);
  EXPECT_EQ(rgb(picture, 0, 0), (std::vector<float>{1.0f, 0.5f, 0.25f}));
  EXPECT_EQ(rgb(picture, 1, 0), (std::vector<float>{255, 0, 1}));
  EXPECT_EQ(rgb(picture, 2, 0), (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(rgb(picture, 3, 0), (std::vector<float>{255 * 0x1p119f, 128 * 0x1p119f, 0x1p119f}));
}

TEST(Hdr, OldRuns) {
  // 300 pixels: one, repeated 43 + 1 * 256 times (two run codes in a row count in steps of 256).
  const ImageF picture =
      decode(header(300, 1) + pixel(10, 20, 30, 136) + pixel(1, 1, 1, 43) + pixel(1, 1, 1, 1));
  for (int x = 0; x < 300; ++x) EXPECT_EQ(rgb(picture, x, 0), (std::vector<float>{10, 20, 30}));
  // A pixel in between starts the count anew.
  const ImageF mixed = decode(header(6, 1) + pixel(10, 20, 30, 136) + pixel(1, 1, 1, 2) +
                              pixel(40, 50, 60, 136) + pixel(1, 1, 1, 2));
  EXPECT_EQ(rgb(mixed, 2, 0), (std::vector<float>{10, 20, 30}));
  EXPECT_EQ(rgb(mixed, 5, 0), (std::vector<float>{40, 50, 60}));
}

TEST(Hdr, NewRuns) {
  const auto b = [](int value) { return std::string(1, static_cast<char>(value)); };
  const std::string row = pixel(2, 2, 0, 10)  //
                          + b(128 + 10) +
                          b(200)  // red: one run
                          // green: four copied, a run of six
                          + b(4) + b(1) + b(2) + b(3) + b(4) + b(128 + 6) + b(9) + b(10) +
                          "abcdefghij"                                  // blue: ten copied
                          + b(128 + 5) + b(136) + b(128 + 5) + b(137);  // exponent
  const ImageF picture = decode(header(10, 2) + row + row);
  for (int y = 0; y < 2; ++y) {
    EXPECT_EQ(rgb(picture, 0, y), (std::vector<float>{200, 1, 'a'}));
    EXPECT_EQ(rgb(picture, 4, y), (std::vector<float>{200, 9, 'e'}));
    EXPECT_EQ(rgb(picture, 9, y), (std::vector<float>{400, 18, 2 * 'j'}));
  }
}

TEST(Hdr, Orientations) {
  const std::string pixels =
      pixel(1, 0, 0, 136) + pixel(2, 0, 0, 136) + pixel(3, 0, 0, 136) + pixel(4, 0, 0, 136);
  const auto reds = [&](const std::string& axes) {
    const ImageF p = decode(header(2, 2, axes) + pixels);
    return std::vector<float>{*p.at(0, 0), *p.at(1, 0), *p.at(0, 1), *p.at(1, 1)};
  };
  EXPECT_EQ(reds("-Y {} +X {}"), (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(reds("-Y {} -X {}"), (std::vector<float>{2, 1, 4, 3}));
  EXPECT_EQ(reds("+Y {} +X {}"), (std::vector<float>{3, 4, 1, 2}));
  EXPECT_EQ(reds("+Y {} -X {}"), (std::vector<float>{4, 3, 2, 1}));
  EXPECT_EQ(error_of(header(2, 2, "+X {} -Y {}") + pixels).find("sky: HDR stores columns"), 0u);
}

TEST(Hdr, ExposureIsNoted) {
  tests::LogLines said;
  const ImageF picture =
      decode("#?RGBE\nEXPOSURE=2.5\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + pixel(128, 128, 128, 129));
  EXPECT_EQ(*picture.at(0, 0), 1.0f);
  ASSERT_EQ(said.all.size(), 1u);
  EXPECT_NE(said.all[0].find("sky: EXPOSURE=2.5"), std::string::npos) << said.all[0];
}

TEST(Hdr, BadHeaders) {
  EXPECT_EQ(error_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd"),
            "sky: HDR has the format \"32-bit_rle_xyze\", expected 32-bit_rle_rgbe");
  for (const char* size : {"-Y 1 +X", "-Y one +X 1", "-Y 1 +X 1 1", "-Z 1 +X 1", "-Y 1 +Y 1", "",
                           "-Y 99999999999999999999 +X 1"}) {
    EXPECT_EQ(error_of(fmt::format("#?RADIANCE\n\n{}\nabcdabcd", size))
                  .find("sky: HDR is damaged: its size must read like"),
              0u)
        << size;
  }
  EXPECT_EQ(error_of("#?RADIANCE\n\n-Y 0 +X 1\n"), "sky: has no pixels (1 x 0)");
  EXPECT_EQ(error_of("#?RADIANCE\n\n-Y -5 +X 1\n"), "sky: has no pixels (1 x -5)");
  EXPECT_EQ(error_of("#?RADIANCE\n" + std::string(100000, 'x')),
            "sky: HDR is truncated or damaged: no end of its header");
  std::string comments = "#?RADIANCE\n";
  for (int i = 0; i < 20000; ++i) comments += "# so it goes\n";
  EXPECT_EQ(error_of(comments), "sky: HDR is truncated or damaged: no end of its header");
}

TEST(Hdr, BadRuns) {
  const std::string leaves = "sky: HDR is damaged: a run of pixels leaves its row";
  EXPECT_EQ(error_of(header(4, 1) + pixel(1, 1, 1, 3) + pixel(9, 9, 9, 9)), leaves)
      << "nothing to repeat yet";
  EXPECT_EQ(error_of(header(4, 1) + pixel(9, 9, 9, 9) + pixel(1, 1, 1, 4)), leaves);
  std::string zero_runs = header(4, 1) + pixel(9, 9, 9, 9);
  for (int i = 0; i < 6; ++i) zero_runs += pixel(1, 1, 1, i < 5 ? 0 : 1);
  EXPECT_EQ(error_of(zero_runs), leaves) << "the shift must not run over";
  EXPECT_EQ(error_of(header(10, 1) + pixel(2, 2, 0, 10) + std::string("\xff\x01", 2)), leaves) << "127 of 10";
  EXPECT_EQ(error_of(header(10, 1) + pixel(2, 2, 0, 10) + std::string("\0\1\1\1", 4)), leaves)
      << "a copy of nothing";
  EXPECT_EQ(error_of(header(10, 1) + pixel(2, 2, 0, 11) + std::string(90, 'x')),
            "sky: HDR is damaged: a row of 11 pixels in a picture 10 wide");
}

}  // namespace
}  // namespace dermis::image::test
