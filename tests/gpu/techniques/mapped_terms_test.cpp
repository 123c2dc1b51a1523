// SPDX-License-Identifier: MIT
// A head blurs the terms that its pixels read, and no others: counted, and not seen in the picture.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

constexpr int map_size = 256;

// The built-in head has 0.58 texels per mm of a map of 256. The three wide ones of these terms are on maps:
// from near to far, fewer and fewer of them spread light further than a pixel.
const std::vector<Gaussian> wide_terms{
    {.variance_mm2 = 0.01, .weight = {0.1, 0.2, 0.3}}, {.variance_mm2 = 0.1, .weight = {0.1, 0.2, 0.2}},
    {.variance_mm2 = 0.5, .weight = {0.1, 0.2, 0.2}},  {.variance_mm2 = 2, .weight = {0.2, 0.1, 0.1}},
    {.variance_mm2 = 6, .weight = {0.2, 0.2, 0.1}},    {.variance_mm2 = 16, .weight = {0.3, 0.1, 0.1}}};

RenderSettings settings_at(double distance) {
  RenderSettings s = with_profile(small_settings("texture-space", 64, map_size), "wide terms", wide_terms);
  s.quality.d_ref = 3;
  s.camera.distance = distance;
  return s;
}

const Scene& kept_head() {
  static const Scene opened = subject("built-in head").open();
  return opened;
}

Renderer& poisoned_renderer() {
  static Renderer shared(Renderer::Options{.poison = true});
  return shared;
}

// Three heads that one batch holds, one behind the other: one with all maps, one with some, one with none.
Scene near_and_far() {
  Scene scene;
  const Asset asset = Asset::built_in();
  int number = 0;
  for (const double z_m : {0.0, -1.5, -12.0}) {
    const double x_m = 0.12 * number++;
    scene.add({.asset = asset, .world_from_asset = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x_m, 0, z_m, 1}});
  }
  scene.add_light({.light = {.colour = {2, 2, 2}, .direction = {-0.4, -0.5, -0.7}}});
  scene.add_light({.light = {.colour = {3, 3, 3}, .direction = {0.2, -0.1, 0.9}}});
  return scene;
}

RenderSettings settings_near_and_far() {
  RenderSettings s = settings_at(1);
  s.camera.distance.reset();
  s.camera.eye_m = {0.1, 0, 0.5};
  s.camera.target_m = {0.1, 0, 0};
  s.quality.d_ref = 6;
  return s;
}

TEST(TermsByNeed, AHeadFarAwayHasNoLightMap) {
  for (const bool translucency : {false, true}) {
    RenderSettings s = settings_at(60);
    s.skin.translucency = translucency;
    const Statistics st = renderer().render(kept_head(), s).statistics;
    EXPECT_EQ(st.mapped_terms, std::vector<int>{0});
    EXPECT_EQ(st.used_size, std::vector<int>{32});
    EXPECT_EQ(st.irradiance_texels, 0u);
    EXPECT_EQ(st.convolved_texels, 0u);
    EXPECT_EQ(st.launched, 0u);
    EXPECT_EQ(st.unshaded_reads, 0u);
    EXPECT_EQ(st.transmission_misses, 0u);
    EXPECT_GT(st.skin_pixels, 0u);
  }
}

// All of its light is that of its pixels: the picture without scattering, to the bit.
TEST(TermsByNeed, ThenItIsDrawnAsWithoutScattering) {
  RenderSettings s = settings_at(60);
  s.skin.profile = "skin";
  s.skin.translucency = false;
  const Picture far = renderer().render(kept_head(), s);
  EXPECT_EQ(far.statistics.mapped_terms, std::vector<int>{0});
  s.technique = "lambert";
  expect_equal_bits(renderer().render(kept_head(), s), far);
}

// With nothing left out each step of the chain launches the whole used square, along both axes. Near by the
// first two start from the light, and share the first axis.
TEST(TermsByNeed, NarrowTermsOfAFarHeadAreNotBlurred) {
  std::vector<int> counts;
  for (const double distance : {2.0, 6.0, 9.0, 30.0, 400.0}) {
    RenderSettings s = settings_at(distance);
    s.quality.cull = s.quality.clip = false;
    const Statistics st = renderer().render(kept_head(), s).statistics;
    ASSERT_EQ(st.mapped_terms.size(), 1u);
    const auto terms = static_cast<std::uint64_t>(st.mapped_terms.front());
    const auto side = static_cast<std::uint64_t>(st.used_size.front());
    // One kernel may not reach as far as the first term that is read: the term before is then blurred, too.
    const std::uint64_t blurred = terms == 0 ? 0 : st.convolved_texels / st.irradiance_texels;
    EXPECT_TRUE(blurred == terms || blurred == terms + 1) << distance;
    EXPECT_EQ(st.convolved_texels, blurred * st.irradiance_texels) << distance;
    const std::uint64_t shared = blurred == 3 ? 1 : 0;
    EXPECT_EQ(st.launched, st.irradiance_texels + (2 * blurred - shared) * side * side) << distance;
    EXPECT_EQ(st.unshaded_reads, 0u) << distance;
    EXPECT_EQ(st.irradiance_texels > 0, terms > 0) << distance;
    counts.push_back(st.mapped_terms.front());
  }
  EXPECT_EQ(counts, (std::vector{3, 2, 1, 0, 0}));
}

// A chain that starts at a wide term starts from the irradiance, with all of the variance of that term.
// Narrow terms of next to no weight are lit per pixel far away: what remains is the profile without them.
TEST(TermsByNeed, TheChainStartsFromTheIrradiance) {
  const std::vector<Gaussian> wide{{.variance_mm2 = 1.6, .weight = {0.4, 0.5, 0.6}},
                                   {.variance_mm2 = 6.4, .weight = {0.3, 0.2, 0.2}},
                                   {.variance_mm2 = 25.6, .weight = {0.3, 0.3, 0.2}}};
  std::vector<Gaussian> all{{.variance_mm2 = 0.16, .weight = {1e-15, 1e-15, 1e-15}},
                            {.variance_mm2 = 0.64, .weight = {1e-15, 1e-15, 1e-15}}};
  all.insert(all.end(), wide.begin(), wide.end());

  for (const bool sparse : {false, true}) {
    SCOPED_TRACE(sparse ? "tiles" : "whole squares");
    RenderSettings s = settings_at(2);
    s.quality.cull = s.quality.clip = sparse;
    s.skin.translucency = false;
    const Picture whole = renderer().render(kept_head(), with_profile(s, "all terms", all));
    const Picture rest = renderer().render(kept_head(), with_profile(s, "wide terms alone", wide));
    EXPECT_EQ(whole.statistics.mapped_terms, std::vector<int>{3});
    EXPECT_EQ(rest.statistics.mapped_terms, std::vector<int>{3});
    EXPECT_EQ(whole.statistics.convolved_texels, rest.statistics.convolved_texels);
    EXPECT_EQ(whole.statistics.launched, rest.statistics.launched);
    expect_equal_bits(rest, whole);
  }
}

// Far from the maps of the baseline by no more than the optimisations may be, at each number of terms.
TEST(TermsByNeed, AreNotMissedInThePicture) {
  for (const double distance : {2.0, 6.0, 9.0, 30.0}) {
    SCOPED_TRACE(distance);
    const RenderSettings s = super_sampled(settings_at(distance), 4);
    const Picture wanted = renderer().render(kept_head(), unoptimised(s)),
                  found = renderer().render(kept_head(), s);
    expect_unseen(downsampled(wanted, 4), downsampled(found, 4));
  }
}

// Heads of one batch, which go through each pass together, and each of them alone: the same texels.
TEST(TermsByNeed, EachHeadOfABatchTakesWhatItNeeds) {
  const Scene scene = near_and_far();
  const RenderSettings s = settings_near_and_far();
  const Statistics all = renderer().render(scene, s).statistics;
  ASSERT_EQ(all.mapped_terms.size(), 3u);
  EXPECT_EQ(all.mapped_terms[0], 3);
  EXPECT_GT(all.mapped_terms[1], 0);
  EXPECT_LT(all.mapped_terms[1], 3);
  EXPECT_EQ(all.mapped_terms[2], 0);
  EXPECT_EQ(all.unshaded_reads, 0u);

  std::uint64_t irradiance = 0, convolved = 0, launched = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    Scene alone = scene;
    for (std::size_t k = 0; k < 3; ++k) alone.set_visible(alone.instances()[k], k == i);
    const Statistics one = renderer().render(alone, s).statistics;
    irradiance += one.irradiance_texels;
    convolved += one.convolved_texels;
    launched += one.launched;
    EXPECT_EQ(one.convolved_texels, one.irradiance_texels * static_cast<std::uint64_t>(all.mapped_terms[i]));
    EXPECT_EQ(one.irradiance_texels > 0, i < 2);
  }
  EXPECT_EQ(all.irradiance_texels, irradiance);
  EXPECT_EQ(all.convolved_texels, convolved);
  EXPECT_EQ(all.launched, launched);
}

// Maps that no head has written hold no numbers here: none is read, and none is multiplied by 0.
TEST(StaleMaps, AreNotReadWhereTermsAreLeftOut) {
  const Scene scene = near_and_far();
  for (const bool translucency : {false, true}) {
    SCOPED_TRACE(translucency ? "translucent" : "opaque");
    RenderSettings s = settings_near_and_far();
    s.skin.translucency = translucency;
    const Picture clean = renderer().render(scene, s), stale = poisoned_renderer().render(scene, s);
    EXPECT_TRUE(std::all_of(stale.linear_rgba.begin(), stale.linear_rgba.end(),
                            [](float value) { return std::isfinite(value); }));
    expect_equal_bits(clean, stale);
    EXPECT_EQ(stale.statistics.unshaded_reads, 0u);
    EXPECT_EQ(stale.statistics.irradiance_texels, clean.statistics.irradiance_texels);
  }
}

// The same frame, moved through all numbers of terms and back: what earlier views have left is not read.
TEST(TermsByNeed, ViewsLeaveNothingToEachOther) {
  PreparedFrame moved = poisoned_renderer().prepare(kept_head(), settings_at(400));
  for (const double distance : {400.0, 9.0, 2.0, 6.0, 30.0, 2.0, 400.0, 4.0}) {
    SCOPED_TRACE(distance);
    moved.set(settings_at(distance));
    expect_equal_bits(renderer().render(kept_head(), settings_at(distance)), moved.picture());
  }
}

TEST(TermsByNeed, AMapThatIsNotStoredIsNotShown) {
  const auto refused = [&](double distance, const std::string& show) {
    RenderSettings s = settings_at(distance);
    s.output.show = show;
    return thrown<InputError>([&] { renderer().render(kept_head(), s); });
  };
  EXPECT_EQ(
      refused(400, "irradiance"),
      "output.show 'irradiance' is not stored from here: with 32 of 256 texels per side all terms are lit "
      "per pixel; without quality.depth all are stored");
  EXPECT_NE(refused(400, "blur:5").find("all terms are lit per pixel"), std::string::npos);
  EXPECT_NE(refused(8, "blur:3").find("the terms before blur:"), std::string::npos);
  EXPECT_NE(refused(8, "blur:0").find("is not known to this technique"), std::string::npos);

  // What is there is shown, and all of it with whole maps.
  for (const auto& [distance, show] : {std::pair(8.0, "irradiance"), {8.0, "blur:5"}, {400.0, "stretch"}}) {
    RenderSettings s = settings_at(distance);
    s.output.show = show;
    EXPECT_GT(renderer().render(kept_head(), s).width, 0) << show;
  }
  RenderSettings whole = settings_at(400);
  whole.quality.depth = false;
  whole.output.show = "blur:0";
  EXPECT_EQ(renderer().render(kept_head(), whole).width, map_size);
}

// The published technique has all maps at any distance.
TEST(TermsByNeed, WithWholeMapsAllTermsAreBlurred) {
  RenderSettings s = unoptimised(settings_at(400));
  s.quality.cull = true;
  const Statistics st = renderer().render(kept_head(), s).statistics;
  EXPECT_EQ(st.mapped_terms, std::vector<int>{6});
  EXPECT_GT(st.irradiance_texels, 0u);
  EXPECT_EQ(st.convolved_texels, 6 * st.irradiance_texels);
}

}  // namespace
}  // namespace dermis::tests
