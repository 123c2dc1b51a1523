// SPDX-License-Identifier: MIT
// Files that are cut, altered or lie about their size end in one clear line.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstring>
#include <functional>
#include <random>

#include "image/files/formats.h"
#include "pictures.h"
#include "support/log_lines.h"

namespace dermis::image::test {
namespace {

struct Sample {
  std::string name;
  Bytes file;
  std::function<std::string(std::span<const std::byte>)> error_of;
};

std::string hdr_text(int width, int height) {
  std::string text = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", height, width);
  for (int y = 0; y < height; ++y) {
    text += {2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 255)};
    for (int c = 0; c < 4; ++c) {
      for (int x = 0; x < width; x += 64) {
        const int count = std::min(64, width - x);
        text += static_cast<char>(x / 64 % 2 == 0 ? 128 + count : count);
        for (const std::uint8_t v : noise(static_cast<std::size_t>(x / 64 % 2 == 0 ? 1 : count),
                                          static_cast<std::uint32_t>(y * 4 + c)))
          text += static_cast<char>(v);
      }
    }
  }
  return text;
}

std::vector<Sample> samples() {
  const auto error8 = [](std::span<const std::byte> b) { return error_of8(b); };
  const auto error_f = [](std::span<const std::byte> b) { return error_of_f(b); };

  std::vector<float> floats;
  for (const std::uint8_t v : noise(100 * 80 * 3, 7)) floats.push_back(static_cast<float>(v) * 0.01f);
  const std::vector<std::uint8_t> bytes = noise(100 * 80 * 4, 8);

  std::vector<Sample> all = {
      {"png", make_png({.width = 100, .height = 80, .palette_rgba = {}}, bytes), error8},
      {"interlaced png",
       make_png({.width = 100, .height = 80, .interlaced = true, .palette_rgba = {}}, bytes), error8},
      {"jpeg", make_jpeg(100, 80, JpegKind::rgb, bytes), error8},
      {"progressive jpeg", make_jpeg(100, 80, JpegKind::progressive, bytes), error8},
      {"hdr", bytes_of(hdr_text(100, 80)), error_f},
      {"tiled exr", make_exr({.width = 100, .height = 80, .tile = 32}, floats), error_f},
  };

  for (int compression = 0; compression < 10; ++compression) {
    all.push_back({fmt::format("exr {}", compression),
                   make_exr({.width = 100, .height = 80, .compression = compression}, floats), error_f});
  }
  return all;
}

TEST(Hostile, CutFilesAreErrors) {
  for (const Sample& sample : samples()) {
    ASSERT_EQ(sample.error_of(sample.file), "no error") << sample.name;
    std::vector<std::size_t> lengths = {
        0, 1, 3, 4, 7, 8, 20, sample.file.size() - 1, sample.file.size() - 2, sample.file.size() - 9};
    for (std::size_t i = 1; i <= 20; ++i) lengths.push_back(sample.file.size() * i / 21);
    for (const std::size_t length : lengths) {
      const std::string error = sample.error_of(std::span(sample.file).first(length));
      EXPECT_NE(error, "no error") << sample.name << " cut to " << length << " of " << sample.file.size();
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
      EXPECT_LT(error.size(), 300u) << error;
      if (length <= 20) continue;  // too short to be recognised
      EXPECT_TRUE(error.find("truncated") != std::string::npos || error.find("damaged") != std::string::npos)
          << sample.name << ": " << error;
    }
  }
}

// Every outcome but an InputError or a picture of the declared size is a bug; memory faults show under the
// sanitizers.
TEST(Hostile, AlteredBytesNeverCrash) {
  std::mt19937 random(1);
  tests::LogLines quiet;
  for (const Sample& sample : samples()) {
    for (int round = 0; round < 150; ++round) {
      Bytes altered = sample.file;
      // headers get their share
      const std::size_t reach = round % 2 == 0 ? std::min<std::size_t>(400, altered.size()) : altered.size();
      for (std::uint32_t i = 0; i <= random() % 4; ++i)
        altered[random() % reach] = static_cast<std::byte>(random());
      const std::string error = sample.error_of(altered);
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
  }
}

void put32(Bytes& file, std::size_t at, std::uint32_t value, bool big_endian) {
  for (std::size_t i = 0; i < 4; ++i)
    file[at + i] = static_cast<std::byte>(value >> 8 * (big_endian ? 3 - i : i));
}

Bytes png_that_claims(std::uint32_t width, std::uint32_t height) {
  Bytes file = make_png({.palette_rgba = {}}, noise(4, 1));
  put32(file, 16, width, true);
  put32(file, 20, height, true);
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<std::uint32_t>(file[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (0xedb88320u & (0u - (crc & 1)));
  }
  put32(file, 29, ~crc, true);
  return file;
}

Bytes jpeg_that_claims(unsigned width, unsigned height) {
  Bytes file = make_jpeg(8, 8, JpegKind::rgb, noise(8 * 8 * 3, 1));
  for (std::size_t i = 0; i + 9 < file.size(); ++i) {
    if (file[i] != std::byte{0xff} || file[i + 1] != std::byte{0xc0}) continue;
    put32(file, i + 5, height << 16 | width, true);
    return file;
  }
  return {};
}

void claim_window(Bytes& exr, std::string_view name_and_type, std::int32_t width, std::int32_t height) {
  const std::string_view text(reinterpret_cast<const char*>(exr.data()), exr.size());
  const std::size_t at = text.find(name_and_type) + name_and_type.size() + 4;
  put32(exr, at + 8, static_cast<std::uint32_t>(width - 1), false);
  put32(exr, at + 12, static_cast<std::uint32_t>(height - 1), false);
}

constexpr std::string_view data_window("dataWindow\0box2i", 17), display_window("displayWindow\0box2i", 20);

Bytes exr_that_claims(std::int32_t width, std::int32_t height, int compression = 3) {
  Bytes file = make_exr({.compression = compression}, std::vector<float>(3, 1.0f));
  claim_window(file, data_window, width, height);
  claim_window(file, display_window, width, height);
  return file;
}

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(Hostile, HugeSizesAreRefusedBeforeMemoryIsTaken) {
  const long before_kib = peak_kib();
  const std::string side = "is 30000 x 4 pixels, the limit is 16384 per side";
  EXPECT_EQ(error_of8(png_that_claims(30000, 4)), "map: " + side);
  EXPECT_EQ(error_of8(jpeg_that_claims(30000, 4)), "map: " + side);
  EXPECT_EQ(error_of_f(exr_that_claims(30000, 4)), "sky: " + side);
  EXPECT_EQ(error_of_f(bytes_of("#?RADIANCE\n\n-Y 4 +X 30000\nabcd")), "sky: " + side);

  EXPECT_EQ(error_of8(png_that_claims(0x7fffffff, 0x7fffffff)).find("map: "), 0u);
  EXPECT_EQ(
      error_of_f(exr_that_claims(0x7fffffff, 0x7fffffff)).find("sky: is 2147483647 x 2147483647 pixels"), 0u);
  EXPECT_EQ(error_of_f(exr_that_claims(0, 5)), "sky: has no pixels (0 x 5)");
  EXPECT_NE(error_of8(png_that_claims(0, 5)), "no error");
  EXPECT_NE(error_of8(jpeg_that_claims(5, 0)), "no error");

  // Within the limits and yet a lie: a few hundred bytes that would cost 1 to 3 GB.
  EXPECT_EQ(error_of8(png_that_claims(16384, 16384)).find("map: is truncated or damaged: "), 0u);
  EXPECT_EQ(error_of8(jpeg_that_claims(16384, 16384)).find("map: is truncated or damaged: "), 0u);
  for (int compression = 0; compression < 10; ++compression) {
    EXPECT_EQ(error_of_f(exr_that_claims(16384, 16384, compression)).find("sky: "), 0u) << compression;
  }
  EXPECT_EQ(
      error_of_f(bytes_of("#?RADIANCE\n\n-Y 8192 +X 16384\nabcd")).find("sky: is truncated or damaged: "),
      0u);

  EXPECT_LT(peak_kib() - before_kib, 200 * 1024);
}

// Black around the data of a cropped picture takes no byte of the file: 345 bytes became 3.2 GB.
TEST(Hostile, AWideDisplayWindowAroundOnePixelIsRefused) {
  const long before_kib = peak_kib();
  Bytes file = make_exr({}, std::vector<float>(3, 1.0f));
  claim_window(file, display_window, 16384, 8192);
  EXPECT_EQ(error_of_f(file), "sky: EXR has a display window of 16384 x 8192 pixels for data of 1 x 1");
  EXPECT_LT(peak_kib() - before_kib, 100 * 1024);

  // A region of a picture that was rendered alone is no lie.
  claim_window(file, display_window, 1024, 1024);
  EXPECT_EQ(error_of_f(file), "no error");
}

// Within what its compression could hold at best, and yet a lie: its rows end the reading before memory for
// all of them is touched.
TEST(Hostile, APictureThatItsFileCouldJustHoldIsNotTakenAtItsWord) {
  const long before_kib = peak_kib();
  constexpr int dwab = 9;
  Bytes file = exr_that_claims(16384, 8192, dwab);
  // Everything behind the header: a table of chunks that lie somewhere, so that none is missing.
  constexpr std::string_view last_attribute("screenWindowWidth\0float\0", 24);
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  file.resize(text.find(last_attribute) + last_attribute.size() + 9);
  file.resize(std::size_t{64} << 10, std::byte{1});
  const std::string error = error_of_f(file);
  EXPECT_EQ(error.find("sky: EXR is truncated"), 0u) << error;
  // It claims 1.5 GiB. A sanitizer keeps up to 256 MiB of what was freed, so less than that proves nothing.
  EXPECT_LT(peak_kib() - before_kib, 512 * 1024);

  // Linear light has half the pixels of other pictures, since each has 12 bytes.
  EXPECT_EQ(error_of_f(bytes_of("#?RADIANCE\n\n-Y 16384 +X 16384\nabcd")),
            "sky: is 16384 x 16384 pixels, the limit is 134217728 in all");
}

TEST(Hostile, LimitsOfTheCaller) {
  const Bytes png = make_png({.width = 20, .height = 10, .palette_rgba = {}}, noise(800, 1));
  EXPECT_EQ(error_of8(png, {.max_side = 20}), "no error");
  EXPECT_EQ(error_of8(png, {.max_side = 19}), "map: is 20 x 10 pixels, the limit is 19 per side");
  EXPECT_EQ(error_of8(png, {.max_side = 100, .max_pixels = 199}),
            "map: is 20 x 10 pixels, the limit is 199 in all");
}

TEST(Hostile, ManyChannelsAndDeepPicturesAreRefused) {
  Bytes deep = make_exr({}, std::vector<float>(3, 1.0f));
  deep[5] |= std::byte{8};
  EXPECT_EQ(error_of_f(deep), "sky: EXR holds a deep picture, expected a flat one");
  Bytes future = make_exr({}, std::vector<float>(3, 1.0f));
  future[4] = std::byte{3};
  EXPECT_EQ(error_of_f(future), "sky: EXR has version 3, expected 2");
}

TEST(Hostile, OtherFormatsAreNamed) {
  const Bytes ktx = bytes_of(std::string_view("\xabKTX 20\xbb\r\n\x1a\n....", 16));
  EXPECT_EQ(error_of8(ktx), "map: is a KTX2 picture, expected PNG or JPEG");
  EXPECT_EQ(error_of8(bytes_of("RIFF....WEBPVP8 ")), "map: is a WebP picture, expected PNG or JPEG");
  EXPECT_EQ(error_of8(bytes_of("GIF89a")), "map: is a GIF picture, expected PNG or JPEG");
  EXPECT_EQ(error_of8(bytes_of("hello")), "map: is of an unknown picture format, expected PNG or JPEG");
  EXPECT_EQ(error_of8({}), "map: is of an unknown picture format, expected PNG or JPEG");
  EXPECT_EQ(error_of8(bytes_of("#?RADIANCE\n")), "map: is a Radiance HDR picture, expected PNG or JPEG");
  EXPECT_EQ(error_of_f(make_png({.palette_rgba = {}}, noise(4, 1))),
            "sky: is a PNG picture, expected Radiance HDR or OpenEXR");
}

}  // namespace
}  // namespace dermis::image::test
