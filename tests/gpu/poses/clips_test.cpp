// SPDX-License-Identifier: MIT
// Whole clips, frame by frame: what is optimised reads no light that was not stored, and does not show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "dermis/scene.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "image/compare_exposed.h"
#include "support/assets.h"
#include "support/log_lines.h"

namespace dermis::tests {
namespace {

constexpr int frames = 48;
constexpr int compared_each = 12;  // frames; the others are drawn once, optimised

struct Character {
  std::string name;
  std::filesystem::path file;  ///< in the asset cache
};

class Clips : public testing::TestWithParam<Character> {
 protected:
  void SetUp() override {
    const std::filesystem::path file = asset_cache() / GetParam().file;
    if (const std::string missing = missing_asset({file}); !missing.empty()) GTEST_SKIP() << missing;
    const Asset asset = Asset::load(file);
    clip_end_s_ = asset.clip_end_s(asset.clips().front());
    head_ = scene_.add({.asset = asset});
    scene_.add_light({.light = {.colour = {3, 2.9, 2.8}, .direction = {-0.8, -0.2, -0.5}}});
  }

  void pose(int frame) { scene_.pose(head_, "", clip_end_s_ * frame / frames); }

  LogLines quiet_;
  Scene scene_;
  InstanceId head_{};
  double clip_end_s_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Characters, Clips,
                         testing::Values(Character{"MakeHuman", "makehuman/mh-asian-woman-young.glb"},
                                         Character{"ICT", "ict-facekit/ict-mean-animated.glb"}),
                         [](const auto& one) { return one.param.name; });

// The mean of 3 x 3 samples per pixel; light maps as for the picture at its own size.
image::ImageF averaged(const Scene& scene, RenderSettings s, double d_ref) {
  s.quality.d_ref = d_ref;
  return downsampled(renderer().render(scene, super_sampled(s, 3)), 3);
}

TEST_P(Clips, ReadOnlyWhatIsLitInEveryFrame) {
  RenderSettings s = small_settings("texture-space", 96, 256);
  s.output.bloom = 0;
  double least_db = 1e9;
  std::vector<float> first;
  bool moves = false;

  for (int i = 0; i < frames; ++i) {
    SCOPED_TRACE("frame " + std::to_string(i));
    pose(i);
    const Picture optimised = renderer().render(scene_, s);
    EXPECT_EQ(optimised.statistics.unshaded_reads, 0u);
    EXPECT_EQ(optimised.statistics.transmission_misses, 0u);
    if (i == 0) first = optimised.linear_rgba;
    moves = moves || optimised.linear_rgba != first;
    if (i % compared_each != 0) continue;

    expect_equal_bits(optimised, renderer().render(scene_, s));
    const double d_ref = optimised.statistics.d_ref;
    const auto d = image::compare_exposed(averaged(scene_, unoptimised(s), d_ref), averaged(scene_, s, d_ref),
                                          s.output.tone_map);
    ASSERT_TRUE(d.has_value()) << "no skin";
    EXPECT_GE(d->psnr_db, unseen_psnr_db);
    EXPECT_LE(d->flip_mean, unseen_flip);
    least_db = std::min(least_db, d->psnr_db);
  }

  EXPECT_TRUE(moves) << "nothing moved";
  std::printf("%s: at least %.1f dB\n", GetParam().name.c_str(), least_db);
}

}  // namespace
}  // namespace dermis::tests
