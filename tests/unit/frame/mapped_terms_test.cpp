// SPDX-License-Identifier: MIT
// How large light maps are, and which terms they hold, from the density of the scan: 1.36 texels per mm on
// average of a map of 1024, 2.5 where it is dense.
#include "render/techniques/mapped_terms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "render/techniques/sides_by_need.h"
#include "render/techniques/texture_space/counters.h"
#include "tissue/gaussians/known.h"

namespace dermis::techniques::test {
namespace {

// As set-up leaves it: T_max and the first term on maps are those of the unwrap.
FrameSettings like_the_scan(std::uint32_t most_side = 2048) {
  FrameSettings s;
  s.skin.push_back({.profile = gaussians::skin_six(),
                    .max_uv_per_mm = 2.5 / 1024,
                    .mean_uv_per_mm = 1.36 / 1024,
                    .wide_mm = 1});
  s.set_most_side(near_side(s.skin[0], most_side));
  s.skin[0].first_mapped = first_mapped(s.skin[0], {s.most_side, 0});
  s.models = {{.meshes = 1}};
  s.optimise.depth = true;
  return s;
}

TEST(MapSide, StepsAreHalfOctaves) {
  EXPECT_EQ(sides_by_need(512), (std::vector<std::uint32_t>{512, 384, 256, 192, 128, 96, 64, 48, 32}));
  EXPECT_EQ(sides_by_need(700), (std::vector<std::uint32_t>{700, 512, 384, 256, 192, 128, 96, 64, 48, 32}));
  EXPECT_EQ(sides_by_need(32), (std::vector<std::uint32_t>{32}));
}

// 1.41 mm take 0.9 texels of 480 per side, 2.72 mm of 249.
TEST(MapSide, HoldsTheWideTerms) {
  const FrameSettings s = like_the_scan();
  EXPECT_EQ(s.most_side, 512u);
  EXPECT_EQ(s.skin[0].first_mapped, 4u);
  EXPECT_EQ(s.skin[0].mapped().size(), 2u);
  EXPECT_EQ(like_the_scan(300).most_side, 300u) << "no more than it may have";
  EXPECT_EQ(like_the_scan(300).skin[0].first_mapped, 4u);
  EXPECT_EQ(like_the_scan(150).skin[0].first_mapped, 5u);
  EXPECT_EQ(like_the_scan(32).skin[0].first_mapped, 5u) << "a map has a term";

  // A scan four times as large, in mm, has four times fewer texels per mm.
  PlannedMesh coarse = s.skin[0];
  coarse.mean_uv_per_mm /= 4;
  EXPECT_EQ(near_side(coarse, 4096), 2048u);
  // Light that spreads no further than 0.3 mm is on maps, too.
  PlannedMesh wax = s.skin[0];
  wax.profile.terms = {{.variance_mm2 = 0.09, .weight = {1, 1, 1}}};
  wax.wide_mm = 0.15;
  EXPECT_EQ(near_side(wax, 4096), 3072u);
}

// From near to far: both terms, the widest, none. Coarse pixels need fewer texels. T never rises.
TEST(MapSide, FollowsThePixels) {
  const FrameSettings s = like_the_scan();
  std::uint32_t before = s.most_side;
  for (double pixels_per_mm = 2; pixels_per_mm > 0.01; pixels_per_mm /= 1.1) {
    const std::uint32_t side = side_by_need(s, s.models[0], pixels_per_mm, s.most_side);
    const bool narrow = 1.411 * pixels_per_mm > 0.6, wide = 2.722 * pixels_per_mm > 0.35;
    const bool coarse = 1.411 * pixels_per_mm < 1.2;
    EXPECT_EQ(side, narrow ? (coarse ? 384u : 512u) : wide ? 256u : 32u) << pixels_per_mm;
    EXPECT_LE(side, before);
    before = side;
    EXPECT_EQ(mapped_count(s, 0, {side, pixels_per_mm}), narrow ? 2 : wide ? 1 : 0) << pixels_per_mm;
  }
}

// Both wide terms take the light before any blur. Light through the body that joins between them, or maps of
// all terms, make a chain.
TEST(MapSide, DirectSteps) {
  FrameSettings s = like_the_scan();
  EXPECT_EQ(direct_steps(s, s.skin[0]), 2u);
  s.translucency = true;
  EXPECT_EQ(direct_steps(s, s.skin[0]), s.skin[0].through_groups().size() > 1 ? 1u : 2u);

  PlannedMesh close = s.skin[0];
  close.first_mapped = 2;
  ASSERT_EQ(close.through_groups().size(), 2u);
  EXPECT_EQ(direct_steps(s, close), close.through_groups()[1]);
  PlannedMesh dense = s.skin[0];
  dense.max_uv_per_mm *= 3;
  EXPECT_EQ(direct_steps(s, dense), 1u) << "no kernel is so wide";

  s.all_mapped = true;
  EXPECT_EQ(direct_steps(s, s.skin[0]), 1u);
}

// Where 0.753 mm are over 2.5 pixels, and 0.432 mm, maps hold them, too.
TEST(MapSide, IsLargerInCloseUps) {
  const FrameSettings s = like_the_scan();
  const auto side = [&](double pixels_per_mm) { return side_by_need(s, s.models[0], pixels_per_mm, 2048); };
  EXPECT_EQ(side(3.2), 512u);
  EXPECT_EQ(side(3.4), 1024u);
  EXPECT_EQ(side(5.7), 1024u);
  EXPECT_EQ(side(5.9), 1536u + 512u);
  EXPECT_EQ(first_mapped(s.skin[0], {1024, 3.4}), 3u);
  EXPECT_EQ(first_mapped(s.skin[0], {1024, 3.2}), 4u);
  EXPECT_EQ(first_mapped(s.skin[0], {2048, 100}), 1u) << "0.08 mm are a fifth of a texel";
}

// What a term has on the map changes little from a frame to the next, also where T changes.
TEST(MappedTerms, FadeBeforeTheyAreLeftOut) {
  const FrameSettings s = like_the_scan();
  std::array<float, 2> before{1, 1};
  for (double pixels_per_mm = 3; pixels_per_mm > 0.01; pixels_per_mm /= 1.01) {
    const passes::MapDetail detail{side_by_need(s, s.models[0], pixels_per_mm, s.most_side), pixels_per_mm};
    const passes::MappedTerms terms = mapped_terms(s, 0, detail);
    for (std::size_t i = 0; i < 2; ++i) {
      const float share = terms.any ? terms.shares[i] : 0;
      EXPECT_NEAR(share, before[i], 0.05) << pixels_per_mm;
      before[i] = share;
    }
  }
  EXPECT_EQ(before, (std::array<float, 2>{0, 0}));
}

// A pixel of 0.5 / 0.35 mm per texel is as coarse as the narrowest term that is read from a map.
TEST(MappedTerms, NarrowLightEntersWherePixelsAreCoarser) {
  const FrameSettings s = like_the_scan();
  const auto share_at = [&](double texels) {
    const double texels_per_mm = s.skin[0].mean_uv_per_mm * 256;
    return entered_share(s.skin[0], {.side = 256, .pixels_per_mm = texels_per_mm / (2 * texels)});
  };
  EXPECT_EQ(share_at(0.34), 0);
  EXPECT_GT(share_at(0.36), 0);
  EXPECT_LT(share_at(0.4), 0.1);
  EXPECT_FLOAT_EQ(share_at(0.6), 0.5f);
}

TEST(MappedTerms, AreAllWhereAHostDrawsTheLight) {
  FrameSettings whole = like_the_scan(), drawn_by_host = whole, in_host = whole, read_by_host = whole;
  whole.optimise = {.cull = true, .depth = false, .clip = true};
  drawn_by_host.host = HostPart{.irradiance = true};
  for (FrameSettings* s : {&whole, &drawn_by_host}) {
    s->skin[0].first_mapped = 0;
    EXPECT_EQ(mapped_terms(*s, 0, {.side = 32}), passes::MappedTerms{});
    EXPECT_EQ(mapped_count(*s, 0, {.side = 32}), 6);
  }
  // They are as in a picture of ours if a host shows the light, or lights the rest itself.
  in_host.host = HostPart{.picture = passes::PictureFormat{}};
  read_by_host.host = HostPart{.scattered = true};
  for (const FrameSettings* s : {&in_host, &read_by_host})
    EXPECT_FALSE(mapped_terms(*s, 0, {.side = 32}).any);
}

// Steps of totals 0.01, 0.65, 2.6, 10.4, 41.6, 100 mm^2. A quarter of the texels takes four times the sigma
// of 1.6 mm that one kernel holds on the whole map: 40.96 mm^2.
TEST(MappedTerms, TheChainStartsWithinReachOfOneKernel) {
  FrameSettings s = like_the_scan();
  s.set_most_side(1024);
  s.skin[0].first_mapped = 0;
  s.skin[0].profile.terms = {{.variance_mm2 = 0.01, .weight = {0.5, 0.5, 0.5}},
                             {.variance_mm2 = 100, .weight = {0.5, 0.5, 0.5}}};
  const passes::MappedTerms terms = mapped_terms(s, 0, {.side = 256});
  EXPECT_TRUE(terms.any);
  EXPECT_EQ(terms.first_read, 1u);
  EXPECT_EQ(terms.first_step, 3u);
  EXPECT_EQ(terms.first_written, 1u);
  EXPECT_EQ(terms.shares[0], 0);
  EXPECT_EQ(terms.shares[1], 1);
}

// Two terms from the light: three passes over the tiles, not four.
TEST(MappedTerms, TermsThatShareReadsAreCountedOnce) {
  const FrameSettings s = like_the_scan();
  std::vector<std::uint32_t> counters(counter_count(s));
  counters[square_counter(s, 0, 0, counter_tiles)] = 10;
  const std::array near{passes::Head{.detail = {.side = 512}}};
  const FrameReport report = find_technique("texture-space").report(s, counters, near);
  ASSERT_EQ(mapped_count(s, 0, near[0].detail), 2);
  EXPECT_EQ(report.launched, 3u * 10 * 64);
}

TEST(MappedTerms, NoGuttersAreMadeForMapsThatAreNotRead) {
  const FrameSettings s = like_the_scan();
  const Technique& technique = find_technique("texture-space");
  const std::array far{passes::Head{.detail = {.side = 96}}, passes::Head{.detail = {.side = 32}}};
  const std::vector<GutterSize> none = technique.gutters(s, far);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none.front().side, 512u) << "the stretch map alone";

  // A head that reads the widest term alone blurs by it at once: three sigma, and two texels.
  const std::array one_term{passes::Head{.detail = {.side = 256}}};
  const std::vector<GutterSize> made = technique.gutters(s, one_term);
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(made.back().width_texels, static_cast<int>(std::ceil(3 * std::sqrt(7.41) * 2.5 / 4)) + 2);

  const std::array hidden{passes::Head{.detail = {.side = 256}, .visible = false}};
  for (const char* name : {"texture-space", "published"})
    EXPECT_EQ(find_technique(name).gutters(s, hidden).size(), 1u) << name;
}

}  // namespace
}  // namespace dermis::techniques::test
