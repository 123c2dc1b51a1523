// SPDX-License-Identifier: MIT
#include "render/passes/scatter/blur/blur.h"

#include <gtest/gtest.h>

#include "render/passes/scatter/kernels.h"

namespace dermis::passes {
namespace {

const std::vector<double> published{0.0064, 0.0484, 0.187, 0.567, 1.99, 7.41};

TEST(BlurSteps, AddUpToTheVariances) {
  for (const double density : {0.5, 2.0, 8.0, 40.0}) {
    double done = 0;
    std::vector<double> ends;
    for (const BlurStep& step : blur_steps(published, density)) {
      done += step.variance_mm2;
      if (step.ends_term) ends.push_back(done);
    }
    ASSERT_EQ(ends.size(), published.size());
    for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends[i], published[i], 1e-9);
  }
}

TEST(BlurSteps, SigmaAtMostDoublesOnceItIsPastTheTexel) {
  for (const double density : {2.0, 8.0, 40.0}) {
    double done = 0;
    const double texel_reach = kernel_max_sigma / density * (kernel_max_sigma / density);
    for (const BlurStep& step : blur_steps({7.41}, density)) {
      EXPECT_LE(step.variance_mm2, std::max(3 * done, texel_reach) * (1 + 1e-6));
      done += step.variance_mm2;
    }
  }
}

TEST(BlurSteps, TheFirstStepFitsTheTaps) {
  EXPECT_LE(blur_steps({7.41}, 8).front().variance_mm2, 16.0 / 64 * (1 + 1e-9));
}

}  // namespace
}  // namespace dermis::passes
