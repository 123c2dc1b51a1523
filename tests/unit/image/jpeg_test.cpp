// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "pictures.h"
#include "support/log_lines.h"

namespace dermis::image::test {
namespace {

// Smooth, so that the loss of quality 95 stays within a few steps.
std::vector<std::uint8_t> ramp(int width, int height, int channels) {
  std::vector<std::uint8_t> samples;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int values[] = {40 + 150 * x / width, 60 + 120 * y / height, 200 - 100 * x / width};
      for (int c = 0; c < channels; ++c) samples.push_back(static_cast<std::uint8_t>(values[c]));
    }
  }
  return samples;
}

void expect_close(const Image8& picture, const std::vector<std::uint8_t>& samples, int channels) {
  ASSERT_EQ(picture.rgba.size() / 4, samples.size() / static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t from = i * static_cast<std::size_t>(channels) + (channels == 1 ? 0 : c);
      ASSERT_NEAR(picture.rgba[i * 4 + c], samples[from], 4) << "pixel " << i << " channel " << c;
    }
    ASSERT_EQ(picture.rgba[i * 4 + 3], 255);
  }
}

TEST(Jpeg, RgbGreyAndProgressive) {
  for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {37, 21}}) {
    expect_close(decode_image8(make_jpeg(width, height, JpegKind::rgb, ramp(width, height, 3)), "map"),
                 ramp(width, height, 3), 3);
    expect_close(
        decode_image8(make_jpeg(width, height, JpegKind::progressive, ramp(width, height, 3)), "map"),
        ramp(width, height, 3), 3);
    expect_close(decode_image8(make_jpeg(width, height, JpegKind::grey, ramp(width, height, 1)), "map"),
                 ramp(width, height, 1), 1);
  }
}

TEST(Jpeg, CmykIsNamed) {
  const std::vector<std::uint8_t> samples(16 * 16 * 4, 100);
  EXPECT_EQ(error_of8(make_jpeg(16, 16, JpegKind::cmyk, samples)),
            "map: JPEG has CMYK colours, expected RGB or grey");
}

// What follows the end marker (thumbnails, padding of cameras) is no damage.
TEST(Jpeg, BytesAfterTheEndAreIgnored) {
  Bytes file = make_jpeg(16, 16, JpegKind::rgb, ramp(16, 16, 3));
  const Image8 clean = decode_image8(file, "map");
  for (int i = 0; i < 100; ++i) file.push_back(std::byte{0x55});
  EXPECT_EQ(decode_image8(file, "map").rgba, clean.rgba);
}

// Each repeat of a scan is a pass over the whole picture; without a limit a small file takes hours.
TEST(Jpeg, EndlessScansAreRefused) {
  const Bytes file = make_jpeg(64, 64, JpegKind::progressive, ramp(64, 64, 3));
  const std::byte marker{0xff};
  const auto is_marker = [&](std::size_t i) { return file[i] == marker && file[i + 1] != std::byte{0}; };

  // Find the first scan: from its marker up to the next one.
  std::size_t begin = 0;
  while (file[begin] != marker || file[begin + 1] != std::byte{0xda}) ++begin;
  std::size_t end = begin + 2;
  while (!is_marker(end)) ++end;

  const auto with_repeats = [&](int count) {
    Bytes repeated(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(end));
    for (int i = 0; i < count; ++i) repeated.insert(repeated.end(), &file[begin], &file[end]);
    repeated.insert(repeated.end(), &file[end], file.data() + file.size());
    return repeated;
  };

  // the order of the scans is odd: one warning
  tests::LogLines quiet;
  EXPECT_EQ(error_of8(with_repeats(20)), "no error");
  EXPECT_EQ(error_of8(with_repeats(1000)), "map: JPEG has more than 200 scans");
}

TEST(Jpeg, BrokenCodesAreErrors) {
  const Bytes good = make_jpeg(64, 64, JpegKind::rgb, noise(64 * 64 * 3, 3));
  // A marker in the middle of the entropy-coded data: the decoder would fill the rest with grey.
  Bytes bad = good;
  bad[bad.size() / 2] = std::byte{0xff};
  bad[bad.size() / 2 + 1] = std::byte{0xd9};
  EXPECT_EQ(error_of8(bad).find("map: JPEG is truncated"), 0u) << error_of8(bad);
}

}  // namespace
}  // namespace dermis::image::test
