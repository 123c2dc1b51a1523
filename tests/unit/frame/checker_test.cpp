// SPDX-License-Identifier: MIT
// The checker itself: each fault, put into a sound list of barriers, is found and named.
#include <gtest/gtest.h>

#include "hazards.h"
#include "made_up.h"

namespace dermis::frame::test {
namespace {

class Checker : public testing::Test {
 protected:
  Checker() {
    map_ = plan_.texture("map", small_map);
    add(plan_, "draw", PassKind::raster, {{Access::colour_target, map_}});
    add(plan_, "read", PassKind::compute, {{Access::sampled, map_}});
    add(plan_, "idle", PassKind::compute, {});
    constexpr VkPipelineStageFlags2 colour = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                    compute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
    constexpr VkAccessFlags2 write = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    // Written by hand: what a careful person would record.
    sound_ = {{{.index = map_.index,
                .source_stages = compute,
                .target_stages = colour,
                .target_access = write | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
                .new_layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                .first_use = true}},
              {{.index = map_.index,
                .source_stages = colour,
                .target_stages = compute,
                .source_access = write,
                .target_access = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                .old_layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                .new_layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}},
              {}};
  }

  void expect_found(const std::string& what) {
    std::string all;
    for (const std::string& line : hazards(plan_, sound_)) all += line + "\n";
    EXPECT_NE(all.find(what), std::string::npos) << what << " is not among:\n" << all;
  }

  Plan plan_;
  TextureId map_;
  std::vector<std::vector<Barrier>> sound_;
};

TEST_F(Checker, IsSilentAboutASoundFrame) { EXPECT_TRUE(hazards(plan_, sound_).empty()); }

TEST_F(Checker, WrongLayout) {
  sound_[1].clear();
  expect_found("'read': 'map' has the wrong layout");
  expect_found("'read': 'map' does not wait for pass draw");
}

TEST_F(Checker, WrongOldLayout) {
  sound_[1][0].old_layout = VK_IMAGE_LAYOUT_GENERAL;
  expect_found("is not in the layout that a barrier starts from");
}

TEST_F(Checker, ContentsLost) {
  sound_[1][0].old_layout = VK_IMAGE_LAYOUT_UNDEFINED;
  expect_found("'read': 'map' loses its contents");
}

TEST_F(Checker, WaitsForTheWrongStage) {
  sound_[1][0].source_stages = VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT;
  expect_found("changes layout while in use by pass draw");
}

TEST_F(Checker, WriteIsNotMadeAvailable) {
  sound_[1][0].source_access = 0;
  expect_found("changes layout before there is an end to the write of pass draw");
}

TEST_F(Checker, WriteIsNotMadeVisible) {
  sound_[1][0].target_access = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
  expect_found("does not see what was written by");
}

TEST_F(Checker, ReaderInAnotherStage) {
  sound_[1][0].target_stages = VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  expect_found("does not wait for pass draw");
}

TEST_F(Checker, FrameDoesNotWaitForTheOneBefore) {
  sound_[0][0].source_stages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
  expect_found("frame 1, pass 'draw': 'map' changes layout while in use by pass read");
}

TEST_F(Checker, AccessThatNoStageCanDo) {
  sound_[1][0].source_access |= VK_ACCESS_2_TRANSFER_WRITE_BIT;
  expect_found("names a source access that its stages cannot do");
}

TEST_F(Checker, BarrierThatNoPassWaitsAt) {
  sound_[2].push_back(sound_[1][0]);
  expect_found("'idle': 'map' has a barrier that no pass waits at");
}

TEST_F(Checker, FirstUseIsNotSaid) {
  sound_[0][0].first_use = false;
  expect_found("is not said rightly to be used for the first time in the frame");
}

}  // namespace
}  // namespace dermis::frame::test
