// SPDX-License-Identifier: MIT
// The environments that people use: read as they are shipped.
#include <gtest/gtest.h>

#include <filesystem>

#include "image/codec.h"
#include "support/assets.h"

namespace dermis::image::test {
namespace {

namespace fs = std::filesystem;

fs::path environment(const std::string& name) { return tests::asset_cache() / "environments" / name; }

class Environments : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string missing = tests::missing_asset({environment("studio_small_09_1k.hdr")});
    if (!missing.empty()) GTEST_SKIP() << missing;
  }
};

struct Range {
  float low = 1e30f, high = -1e30f;
  double mean = 0;
};

Range range(const ImageF& picture) {
  Range r;
  for (const float v : picture.values) {
    r.low = std::min(r.low, v);
    r.high = std::max(r.high, v);
    r.mean += static_cast<double>(v);
  }
  r.mean /= static_cast<double>(picture.values.size());
  return r;
}

TEST_F(Environments, RadianceFiles) {
  for (const char* name : {"studio_small_09_1k.hdr", "venice_sunset_1k.hdr"}) {
    const ImageF picture = load_image_f(environment(name));
    EXPECT_EQ(picture.width, 1024) << name;
    EXPECT_EQ(picture.height, 512) << name;
    const Range r = range(picture);
    EXPECT_GE(r.low, 0.0f) << name;
    EXPECT_GT(r.high, 5.0f) << name << ": lamps and the sun are far brighter than white";
    EXPECT_GT(r.mean, 0.05) << name;
    EXPECT_LT(r.mean, 10) << name;
  }
}

TEST_F(Environments, ZipHalfAndDwabFloatHoldTheSamePixels) {
  for (const char* name : {"studio", "sunset"}) {
    const ImageF zip = load_image_f(environment(std::string("exr/blender-") + name + "-zip-half.exr"));
    const ImageF dwab = load_image_f(environment(std::string("exr/blender-") + name + "-dwab-float.exr"));
    ASSERT_EQ(zip.width, dwab.width);
    ASSERT_EQ(zip.height, dwab.height);
    EXPECT_GT(range(zip).high, 1.0f);
    std::size_t different = 0;
    for (std::size_t i = 0; i < zip.values.size(); ++i) different += zip.values[i] != dwab.values[i] ? 1 : 0;
    EXPECT_EQ(different, 0u) << name;
  }
}

TEST_F(Environments, DwabHalf) {
  const ImageF picture = load_image_f(environment("exr/pmndrs-studio-512-dwab-half.exr"));
  EXPECT_EQ(picture.width, 512);
  EXPECT_EQ(picture.height, 256);
  EXPECT_GT(range(picture).high, 1.0f);
}

}  // namespace
}  // namespace dermis::image::test
