// SPDX-License-Identifier: MIT
// What the optimisations leave out is not missed: pictures with and without them, from all sides, near, far,
// in a row and on the move.
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/support/failure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "image/compare_exposed.h"
#include "support/assets.h"

namespace dermis::tests {
namespace {

constexpr int super = 3;  // samples per pixel, along each axis

// The mean of super x super samples per pixel; light maps as for the picture at its own size.
image::ImageF averaged(PreparedFrame& frame, RenderSettings s, double d_ref) {
  s.output.bloom = 0;
  s.quality.d_ref = d_ref;
  frame.set(super_sampled(s, super));
  return downsampled(frame.picture(), super);
}

// The published picture.
RenderSettings published(RenderSettings s) { return unoptimised(s); }

RenderSettings small_view() {
  RenderSettings s = small_settings("texture-space", 144, 512);
  s.quality.light_samples = 1;  // as the published picture has
  s.output.height = 90;
  return s;
}

class Views : public WithScan {
 protected:
  void expect_same_picture(PreparedFrame& optimised, const RenderSettings& s, const std::string& view) const;

  static void TearDownTestSuite() { shared_baseline.reset(); }

 private:
  // Draws a view of small_view().
  const image::ImageF& published_picture(const RenderSettings& s, double d_ref,
                                         const std::string& view) const {
    if (!shared_baseline) shared_baseline = renderer().prepare(scan(), published(small_view()));
    const auto [picture, is_new] = shared_pictures.try_emplace(fmt::format("{}, d_ref {}", view, d_ref));
    if (is_new) picture->second = averaged(*shared_baseline, published(s), d_ref);
    return picture->second;
  }

  inline static std::optional<PreparedFrame> shared_baseline;
  inline static std::map<std::string, image::ImageF> shared_pictures;
};

void Views::expect_same_picture(PreparedFrame& optimised, const RenderSettings& s,
                                const std::string& view) const {
  SCOPED_TRACE(view);
  optimised.set(s);
  const Statistics st = optimised.picture().statistics;
  EXPECT_EQ(st.unshaded_reads, 0u);
  const image::ImageF& whole = published_picture(s, st.d_ref, view);
  const image::ImageF left_out = averaged(optimised, s, st.d_ref);
  const auto d = image::compare_exposed(whole, left_out, s.output.tone_map);
  ASSERT_TRUE(d.has_value()) << "no skin";
  EXPECT_GE(d->psnr_db, unseen_psnr_db) << write_failure(whole, left_out);
  EXPECT_LE(d->flip_mean, unseen_flip) << write_failure(whole, left_out);
  EXPECT_TRUE(d->mean_display >= 0.25 && d->mean_display <= 0.5) << d->mean_display;
  EXPECT_GT(d->pixels, 50u);
  std::cout << view << ": " << d->psnr_db << " dB, FLIP " << d->flip_mean << ", " << d->pixels << " pixels\n";
}

TEST_F(Views, FromAllSides) {
  PreparedFrame optimised = renderer().prepare(scan(), small_view());
  const double elevations[] = {0, 30, -20};
  for (int k = 0; k < 12; ++k) {
    RenderSettings s = small_view();
    s.camera.orbit_deg = {30.0 * k + 1, elevations[k % 3]};
    expect_same_picture(
        optimised, s, fmt::format("azimuth {}, elevation {}", s.camera.orbit_deg[0], s.camera.orbit_deg[1]));
  }
}

TEST_F(Views, NearAndFarAndInARow) {
  PreparedFrame optimised = renderer().prepare(scan(), small_view());
  for (const auto& [distance, heads] : {std::pair(2.5, 1), {5.0, 1}, {5.0, 4}, {20.0, 1}, {50.0, 6}}) {
    RenderSettings s = small_view();
    s.camera.distance = distance;
    s.camera.heads = heads;
    expect_same_picture(optimised, s, fmt::format("{} heads at {} radii", heads, distance));
  }
}

RenderSettings dolly_view() {
  RenderSettings s = small_view();
  s.output.width = 320;
  s.output.height = 200;
  s.quality.map_size = 352;  // texels per pixel about as in the paper's test
  s.quality.shadow_size = 512;
  s.output.bloom = 0;
  return s;
}

// Of 200 steps from 2.5 to 100 radii those in which maps shrink to a third.
constexpr int dolly_steps = 40;
double dolly_distance(int step) { return 5 * std::pow(100 / 2.5, step / 199.0); }

const std::vector<Picture>& published_dolly(const Scene& scene) {
  static const std::vector<Picture> drawn = [&] {
    RenderSettings s = published(dolly_view());
    PreparedFrame baseline = renderer().prepare(scene, s);
    std::vector<Picture> pictures;
    for (int i = 0; i < dolly_steps; ++i) {
      s.camera.distance = dolly_distance(i);
      baseline.set(s);
      pictures.push_back(baseline.picture());
    }
    return pictures;
  }();
  return drawn;
}

// Maps change their size on the way: that must not show as jumps.
TEST_F(Views, ADollyIsAsSteadyAsTheBaseline) {
  RenderSettings s = dolly_view();
  PreparedFrame optimised = renderer().prepare(scan(), s);
  std::vector<std::uint8_t> last;
  double worst = 0;
  for (int i = 0; i < dolly_steps; ++i) {
    s.camera.distance = dolly_distance(i);
    optimised.set(s);
    const Picture b = optimised.picture();

    if (i > 0) {
      const auto step = published_dolly(scan()).begin() + i;
      const Picture &a = *step, &before = step[-1];
      double change[2] = {}, values = 0;
      for (std::size_t p = 0; p < a.display_rgba.size(); ++p) {
        if (p % 4 == 3 || (a.linear_rgba[p | 3] == 0 && before.linear_rgba[p | 3] == 0)) continue;
        change[0] += std::abs(int{a.display_rgba[p]} - int{before.display_rgba[p]});
        change[1] += std::abs(int{b.display_rgba[p]} - int{last[p]});
        ++values;
      }
      // A jump of maps from one size to the next is seen where a frame changes by more than its neighbours:
      // twice the change that the dolly makes by itself.
      EXPECT_LE(change[1], 2 * change[0])
          << "from " << *s.camera.distance << " radii on, over " << values << " values";
      worst = std::max(worst, change[1] / change[0]);
    }

    last = b.display_rgba;
  }

  std::cout << "largest ratio of changes " << worst << "\n";
}

// Triangles of the crowd's coarsest heads are thinner than a texel where others around them are culled: views
// in which such were read unlit.
TEST(CoarseHeads, EveryReadFindsLight) {
  const std::filesystem::path crowd = asset_cache() / "makehuman" / "crowd";

  const std::pair<const char*, std::array<double, 2>> views[] = {
      {"african-man-old", {90, -30}},      {"african-man-old", {135, -30}},
      {"african-man-old", {180, 0}},       {"asian-woman-young", {45, -30}},
      {"asian-woman-young", {22.5, 60}},   {"european-man-young", {90, 0}},
      {"european-woman-young", {45, -30}}, {"south-asian-man-middleage", {112.5, 0}}};

  for (const auto& [name, orbit_deg] : views) {
    const std::filesystem::path file = crowd / ("mh-crowd-" + std::string(name) + "-lod2.glb");
    if (const std::string missing = missing_asset({file}); !missing.empty()) GTEST_SKIP() << missing;

    RenderSettings s;
    s.output.width = 192;
    s.output.height = 120;
    s.quality.map_size = s.quality.shadow_size = 512;
    s.lighting.rig_lights = 2;
    s.camera.orbit_deg = orbit_deg;
    EXPECT_EQ(renderer().render(Scene::load(file), s).statistics.unshaded_reads, 0u)
        << name << " " << orbit_deg[0] << " " << orbit_deg[1];
  }
}

Statistics of_row(int heads, double distance, double budget_mb) {
  RenderSettings s = small_settings("texture-space");
  s.camera.heads = heads;
  s.camera.distance = distance;
  s.quality.map_budget_mb = budget_mb;
  Renderer fresh;
  return fresh.render(sphere(0.1), s).statistics;
}

// Heads beyond the budget come in batches: memory holds their lights and shadow matrices, nothing else.
TEST(MemoryOfHeads, DoesNotGrowWithTheNumberOfHeads) {
  const Statistics few = of_row(8, 3, 12), many = of_row(16, 3, 12);
  ASSERT_EQ(std::ranges::max(few.used_size), 256);
  EXPECT_EQ(many.image_bytes, few.image_bytes);
  EXPECT_LE(many.peak_bytes, few.peak_bytes + 12 * 65536);
}

// Squares of the pool are as small as the heads of the frame allow: what holds four near heads holds seven
// that use three quarters of the texels of a side, which then go through each pass together.
TEST(MemoryOfHeads, FarHeadsShareWhatFewNearOnesTake) {
  const Statistics near = of_row(4, 3, 12), far = of_row(7, 16, 12), farther = of_row(16, 40, 12);
  ASSERT_EQ(std::ranges::max(near.used_size), 256);
  ASSERT_LE(std::ranges::max(far.used_size), 192);
  ASSERT_LE(std::ranges::max(farther.used_size), 64);
  EXPECT_EQ(far.passes.size(), near.passes.size());
  EXPECT_EQ(farther.passes.size(), near.passes.size());
  EXPECT_LT(far.light_map_bytes, near.light_map_bytes);
  EXPECT_LT(farther.light_map_bytes, far.light_map_bytes);
}

TEST(MemoryOfHeads, ABudgetSetsHowManyHeadsGoTogether) {
  RenderSettings s = small_settings("texture-space");
  s.camera.heads = 5;
  s.camera.distance = 20;
  s.quality.depth = false;
  const Picture four = renderer().render(sphere(0.1), s);
  s.quality.map_budget_mb = 7;  // one head at 256 takes 6.0 MB
  const Picture single = renderer().render(sphere(0.1), s);
  EXPECT_LT(single.statistics.image_bytes, four.statistics.image_bytes);
  // A position in the pool rounds by where its square lies.
  EXPECT_LE(display_difference(four, single).largest, 1);
  EXPECT_GT(single.statistics.passes.size(), four.statistics.passes.size());
  s.quality.map_budget_mb = 1;
  EXPECT_THROW(renderer().render(sphere(0.1), s), InputError);
}

}  // namespace
}  // namespace dermis::tests
