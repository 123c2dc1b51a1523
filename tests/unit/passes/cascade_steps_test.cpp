// SPDX-License-Identifier: MIT
#include "passes/cascade_steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "passes/kernels.h"

namespace dermis::passes {
namespace {

const std::vector<double> published_mm2{0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};

// The variance of each term on its way through all narrower steps is its own, and what moving adds is taken
// off once: by heads that take all steps, and by those that begin with a later one.
TEST(CascadeSteps, EachTermGetsItsVariance) {
  for (const double texels_per_mm : {0.4, 1.0, 1.36, 2.5, 4.0, 7.3}) {
    const CascadeDensity density{.max_texels_per_mm = 1.5 * texels_per_mm,
                                 .mean_texels_per_mm = texels_per_mm,
                                 .coarse_texels_per_mm = texels_per_mm / 1.5};
    const std::uint32_t narrow = narrow_terms(published_mm2, texels_per_mm, 4);
    const std::vector<CascadeStep> steps = cascade_steps(published_mm2, narrow, density, 3);

    double variance_mm2 = 0, share = 0;
    std::size_t terms = narrow;
    for (const CascadeStep& step : steps) {
      const double ratio = 1u << step.halvings;
      variance_mm2 += step.variance_mm2;
      share += step.share;
      EXPECT_NEAR(step.total_mm2, variance_mm2, 1e-9);
      EXPECT_NEAR(step.share_done, share, 1e-9);
      EXPECT_GE(step.halvings, step.halvings_after);
      if (!step.term) continue;
      EXPECT_EQ(*step.term, terms);
      EXPECT_NEAR(variance_mm2, published_mm2[terms++], 1e-9);
      EXPECT_NEAR(share, 1, 1e-9);
      share = 0;

      // At least a texel of the level wide, and the step has a variance left, in the coarsest direction.
      if (step.halvings == 0) continue;
      EXPECT_GE(std::sqrt(step.total_mm2) * density.coarse_texels_per_mm / ratio, level_sigma);
      EXPECT_GT(step.total_mm2 * std::pow(density.coarse_texels_per_mm, 2), moved_texels2(ratio));
    }
    EXPECT_EQ(terms, published_mm2.size());

    for (std::uint32_t first = 0; first < steps.size(); ++first) {
      double moved = 0, blurred_mm2 = 0;
      for (std::uint32_t halvings = 0; halvings <= 3; ++halvings) {
        const auto ratio = [](std::uint32_t n) { return static_cast<double>(1u << n); };
        const io::CascadeLevelIo level =
            cascade_level(steps, first, halvings, std::vector<float>(6, 1), ratio(halvings),
                          ratio(level_after(steps, first, halvings)), 1);
        if (level.terms > 0) moved += level.moved_texels2;
        for (std::uint32_t i = 0; i < level.terms; ++i) blurred_mm2 += level.steps_mm2[i];
      }
      EXPECT_NEAR(moved, moved_texels2(1u << steps.back().halvings), 1e-5);
      EXPECT_NEAR(blurred_mm2, published_mm2.back(), 1e-5);
    }
  }
}

TEST(CascadeSteps, LevelsFollowTheDensity) {
  const auto coarsest = [](double texels_per_mm) {
    return cascade_steps(published_mm2, 0, {texels_per_mm, texels_per_mm, texels_per_mm}, 3).back().halvings;
  };
  EXPECT_EQ(coarsest(0.7), 0u);
  EXPECT_EQ(coarsest(0.75), 1u);
  EXPECT_EQ(coarsest(1.5), 2u);
  EXPECT_EQ(coarsest(40), 3u);
}

}  // namespace
}  // namespace dermis::passes
