// SPDX-License-Identifier: MIT
// Which frames can be shaded in compute: what ids tell apart, and what the buffers of the entries hold.
#include <gtest/gtest.h>

#include "shared/entries_io.h"
#include "techniques/technique.h"

namespace dermis::tests {
namespace {

techniques::FrameSettings heads_of(std::size_t heads, std::uint32_t draws, std::uint32_t triangles) {
  techniques::FrameSettings s;
  s.heads.assign(heads, 0);
  s.skin.push_back({.triangles = triangles, .draws = draws});
  s.models = {{.first_mesh = 0, .meshes = 1}};
  return s;
}

TEST(ShadingLimits, PartsOfAFrame) {
  EXPECT_TRUE(heads_of(4095, 1, 12).can_shade_entries());
  EXPECT_FALSE(heads_of(4096, 1, 12).can_shade_entries());
  EXPECT_TRUE(heads_of(1365, 3, 12).can_shade_entries());
  EXPECT_FALSE(heads_of(1366, 3, 12).can_shade_entries());
}

TEST(ShadingLimits, TrianglesOfAMesh) {
  EXPECT_TRUE(heads_of(1, 1, 1u << 20).can_shade_entries());
  EXPECT_FALSE(heads_of(1, 1, (1u << 20) + 1).can_shade_entries());
}

TEST(ShadingLimits, PixelsOfAPicture) {
  techniques::FrameSettings s = heads_of(1, 1, 12);
  s.width = 4096, s.height = 2047;
  EXPECT_TRUE(s.can_shade_entries());
  s.height = 2048;
  EXPECT_FALSE(s.can_shade_entries());
}

TEST(ShadingLimits, AHostLeavesRoom) {
  techniques::FrameSettings s = heads_of(1, 1, 12);
  s.host = techniques::HostPart{.picture = passes::PictureFormat{}};
  EXPECT_FALSE(s.can_shade_entries());
  s.host->width = s.host->height = 64;
  EXPECT_TRUE(s.can_shade_entries());
  s.host->picture.reset();
  EXPECT_FALSE(s.can_shade_entries());
}

TEST(ShadingLimits, WithoutSkinThereIsNothingToShade) {
  techniques::FrameSettings s;
  EXPECT_FALSE(s.can_shade_entries());
}

// The last id of the last part is not that of the background, and fits.
TEST(ShadingLimits, IdsFit) {
  constexpr std::uint64_t last = (std::uint64_t{MOST_PARTS} << ID_TRIANGLE_BITS) + MOST_TRIANGLES - 1;
  static_assert(last == 0xFFFFFFFFu);
  static_assert(MOST_PARTS <= 1u << (32 - SAMPLES_BITS));
  static_assert(MOST_SHADED_PIXELS <= 1u << PIXEL_BITS);
  constexpr std::uint64_t most_entries = 4 * std::uint64_t{MOST_SHADED_PIXELS};
  static_assert(MOST_PARTS * sizeof(io::PartRangeIo) + most_entries * sizeof(std::uint32_t) <= 128u << 20);
  SUCCEED();
}

}  // namespace
}  // namespace dermis::tests
