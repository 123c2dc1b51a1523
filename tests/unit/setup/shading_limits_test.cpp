// SPDX-License-Identifier: MIT
// What ids tell apart, and what the lists of the entries hold.
#include <gtest/gtest.h>

#include "render/passes/asset/gpu_asset.h"
#include "render/passes/pixels/pixel_area.h"
#include "render/shared/entries_io.h"
#include "render/techniques/technique.h"

namespace dermis::tests {
namespace {

TEST(ShadingLimits, PartsOfAFrame) {
  techniques::FrameSettings s;
  EXPECT_FALSE(s.has_skin());
  s.heads.assign(1000, 0);
  s.skin.push_back({.parts = 3});
  s.skin.push_back({.parts = 2});
  s.models = {{.first_mesh = 0, .meshes = 2}};
  EXPECT_EQ(s.parts(), 5000u);
  EXPECT_TRUE(s.has_skin());
}

TEST(ShadingLimits, PartsOfARunOfTriangles) {
  const auto parts = [](std::uint32_t triangles) {
    return passes::GpuDraw{.first_index = 300, .index_count = 3 * triangles}.parts();
  };
  EXPECT_EQ(parts(1), 1u);
  EXPECT_EQ(parts(65536), 1u);
  EXPECT_EQ(parts(65537), 2u);
  EXPECT_EQ(parts(1 << 20), 16u);
}

TEST(ShadingLimits, RowsOfABand) {
  const passes::PixelArea heads{{3, 10}, {20, 30}};
  const passes::PixelArea begin = passes::rows_of(heads, 0, 16), end = passes::rows_of(heads, 16, 32);
  EXPECT_EQ(begin.low, glm::uvec2(3, 10));
  EXPECT_EQ(begin.high, glm::uvec2(20, 16));
  EXPECT_EQ(end.low, glm::uvec2(3, 16));
  EXPECT_EQ(end.high, glm::uvec2(20, 30));
  EXPECT_EQ(passes::rows_of(heads, 32, 48).size(), glm::uvec2(0));
  EXPECT_EQ(passes::rows_of({}, 0, 16).size(), glm::uvec2(0));
}

// The last id of the last part is not that of the background, and fits, as does the longest list of a band.
TEST(ShadingLimits, IdsAndListsFit) {
  constexpr std::uint64_t triangles = std::uint64_t{1} << ID_TRIANGLE_BITS;
  static_assert(MOST_PARTS * triangles + triangles - 1 == 0xFFFFFFFFu);
  static_assert(MOST_PARTS < 1u << (32 - SAMPLES_BITS));
  static_assert(MOST_BAND_PIXELS <= 1u << PIXEL_BITS);
  constexpr std::uint64_t most_entries = 4 * std::uint64_t{MOST_BAND_PIXELS};
  static_assert(MOST_PARTS * sizeof(io::PartRangeIo) + most_entries * sizeof(std::uint32_t) <= 128u << 20);
  SUCCEED();
}

}  // namespace
}  // namespace dermis::tests
