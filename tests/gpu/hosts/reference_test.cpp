// SPDX-License-Identifier: MIT
// Ground truth takes the hooks of every other call, and keeps what it has when they end it.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

class GroundTruth : public testing::Test {
 protected:
  GroundTruth() {
    settings_.output.exposure_ev = 0;
    settings_.lighting.environment = "studio";
    reference_.samples = 12;
    reference_.checkpoint = folder_.path() / "a.resume";
  }
  ReferencePicture rendered(const Hooks& hooks = {}) const {
    return render_reference(scene_, settings_, reference_, hooks);
  }
  bool has_checkpoint() const { return std::filesystem::exists(reference_.checkpoint); }

  const Scene scene_ = wrap(scene::sphere(0.0713, 6));
  const TempFolder folder_;
  RenderSettings settings_ = small_settings("lambert", 32, 64);
  ReferenceSettings reference_;
};

TEST_F(GroundTruth, TellsOfItsSetUpAndOfItsSamples) {
  std::vector<std::string> works;
  double last = 0;
  const auto tell = [&](const WorkProgress& work) {
    if (works.empty() || works.back() != work.what) works.push_back(work.what), last = 0;
    EXPECT_GE(work.share, last);
    last = work.share;
    return true;
  };
  const ReferencePicture truth = rendered({.progress = tell});
  EXPECT_TRUE(truth.complete);
  EXPECT_EQ(works, (std::vector<std::string>{"preparing the ground truth", "ground truth"}));
  EXPECT_EQ(last, 1);

  // As many samples as a noise needs are not known before.
  reference_.samples.reset();
  reference_.noise_percent = 20;
  last = 0;
  EXPECT_TRUE(rendered({.progress = tell}).complete);
  EXPECT_EQ(last, 1);
}

TEST_F(GroundTruth, IsEndedInItsSetUpToo) {
  for (const double share : {0.0, 0.3, 0.6})
    EXPECT_EQ(thrown<Cancelled>([&] {
                rendered({.progress = [&](const WorkProgress& work) { return work.share <= share; }});
              }),
              "stopped: preparing the ground truth");
  const std::atomic<bool> stop{true};
  EXPECT_THROW(rendered({.stop = &stop}), Cancelled);
  EXPECT_FALSE(has_checkpoint());
}

TEST_F(GroundTruth, KeepsWhatItHasWhenAHookEndsIt) {
  const std::vector<float> whole = rendered().picture.linear_rgba;

  const auto half = [](const WorkProgress& work) { return work.what != "ground truth" || work.share < 0.5; };
  const ReferencePicture stopped = rendered({.progress = half});
  EXPECT_FALSE(stopped.complete);
  EXPECT_GT(stopped.samples, 0);
  EXPECT_LT(stopped.samples, 12);
  ASSERT_TRUE(has_checkpoint());
  reference_.resume = true;
  EXPECT_TRUE(rendered().picture.linear_rgba == whole);

  // Before every pixel has a sample there is nothing to keep.
  std::filesystem::remove(reference_.checkpoint);
  reference_.resume = false;
  EXPECT_EQ(thrown<Cancelled>([&] {
              rendered({.progress = [](const WorkProgress& work) { return work.what != "ground truth"; }});
            }),
            "stopped: ground truth");
  EXPECT_FALSE(has_checkpoint());
}

TEST_F(GroundTruth, WritesItsCheckpointBeforeAnExceptionOfAHook) {
  const auto raise = [](const WorkProgress& work) -> bool {
    if (work.what == "ground truth" && work.share > 0.5) throw std::domain_error("of the host");
    return true;
  };
  EXPECT_THROW(rendered({.progress = raise}), std::domain_error);
  EXPECT_TRUE(has_checkpoint());
}

// With samples of its own, on the same threads.
TEST_F(GroundTruth, AHookMayComputeGroundTruth) {
  int computed = 0;
  const ReferencePicture outer = rendered({.progress = [&](const WorkProgress& work) {
    if (work.what == "ground truth" && computed < 8) {
      ++computed;
      EXPECT_TRUE(rendered().complete);
    }
    return true;
  }});
  EXPECT_TRUE(outer.complete);
  EXPECT_EQ(computed, 8);
}

}  // namespace
}  // namespace dermis::tests
