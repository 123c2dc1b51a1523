// SPDX-License-Identifier: MIT
// Which terms a map of T x T texels is made for, from the density of the scan: 1.36 texels per mm on average
// at T_max = 1024, 2.5 where it is dense.
#include "techniques/mapped_terms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gaussians/known.h"

namespace dermis::techniques::test {
namespace {

FrameSettings like_the_scan() {
  FrameSettings s{.map_size = 1024};
  s.skin.push_back({.profile = gaussians::skin_six(),
                    .max_uv_per_mm = 2.5 / 1024,
                    .max_texels_per_mm = 2.5,
                    .mean_texels_per_mm = 1.36});
  s.models = {{.meshes = 1}};
  s.optimise.depth = true;
  return s;
}

TEST(MappedTerms, AreFewerOnSmallerMaps) {
  const FrameSettings s = like_the_scan();
  for (const auto& [side, first] :
       {std::pair(1024u, 0u), {768u, 0u}, {480u, 3u}, {256u, 4u}, {128u, 5u}, {96u, 6u}, {32u, 6u}}) {
    const passes::MappedTerms terms = mapped_terms(s, 0, side);
    EXPECT_EQ(terms.first_read, first) << side;
    EXPECT_EQ(terms.any, first < 6) << side;
    EXPECT_EQ(mapped_count(s, 0, side), static_cast<int>(6 - first)) << side;
    if (!terms.any) continue;
    // One step to a term each, and the first that is read is within one.
    EXPECT_EQ(terms.first_step, first) << side;
    EXPECT_EQ(terms.first_written, first) << side;
  }
}

TEST(MappedTerms, AreAllWhereMapsAreReadByOthers) {
  FrameSettings whole = like_the_scan(), drawn_by_host = whole, read_by_host = whole, in_host = whole;
  whole.optimise = {.cull = true, .depth = false, .clip = true};
  drawn_by_host.host = HostPart{.irradiance = true};
  read_by_host.host = HostPart{.scattered = true};
  for (const FrameSettings& s : {whole, drawn_by_host, read_by_host}) {
    EXPECT_EQ(mapped_terms(s, 0, 32), passes::MappedTerms{});
    EXPECT_EQ(mapped_count(s, 0, 32), 6);
  }
  // Where a host's picture is all there is, it is as in a picture of ours.
  in_host.host = HostPart{.picture = passes::PictureFormat{}};
  EXPECT_FALSE(mapped_terms(in_host, 0, 32).any);
}

// Steps of totals 0.01, 0.65, 2.6, 10.4, 41.6, 100 mm^2. A quarter of the texels takes four times the sigma
// of 0.8 mm with which the whole map begins: 10.24 mm^2.
TEST(MappedTerms, TheChainStartsWithinReachOfOneKernel) {
  FrameSettings s = like_the_scan();
  s.skin[0].profile.terms = {{.variance_mm2 = 0.01, .weight = {0.5, 0.5, 0.5}},
                             {.variance_mm2 = 100, .weight = {0.5, 0.5, 0.5}}};
  EXPECT_EQ(mapped_terms(s, 0, 256),
            (passes::MappedTerms{.any = true, .first_read = 1, .first_step = 2, .first_written = 1}));
  EXPECT_EQ(mapped_terms(s, 0, 1024), passes::MappedTerms{});
}

TEST(MappedTerms, NoGuttersAreMadeForMapsThatAreNotRead) {
  const FrameSettings s = like_the_scan();
  const Technique& technique = find_technique("texture-space");
  const std::array far{DrawnHead{.side = 96}, DrawnHead{.side = 32}};
  const std::vector<GutterSize> none = technique.gutters(s, far);
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none.front().side, 1024u) << "the stretch map alone";

  // The widest step is then the first: 7.41 mm^2 at once, three sigma of it at 2.5 / 8 texels per mm, and
  // two.
  const std::array one_term{DrawnHead{.side = 128}};
  const std::vector<GutterSize> made = technique.gutters(s, one_term);
  ASSERT_EQ(made.size(), 2u);
  EXPECT_EQ(made.back().width_texels, static_cast<int>(std::ceil(3 * std::sqrt(7.41) * 2.5 / 8)) + 2);
}

}  // namespace
}  // namespace dermis::techniques::test
