// SPDX-License-Identifier: MIT
// Way (ii): heads in the host's depth pre-pass and shadow maps.
#include <algorithm>

#include "frame.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"

namespace dermis::tests {
namespace {

using EmbeddedDepth = WithHost;

vulkan::HostFrames::Options picture_and_depth(bool reversed = true) {
  return {.picture = vulkan::PictureTargets{.reversed_depth = reversed},
          .depths = {vulkan::DepthTargets{.reversed_depth = reversed}}};
}

vulkan::DepthView pre_pass(const Frame& frame) {
  return {.depth = frame.depth_image.view, .extent = {side, side}, .cull = true};
}

class EmbeddedDepthByDirection : public WithHost, public testing::WithParamInterface<bool> {};

TEST_P(EmbeddedDepthByDirection, APrePassHasTheDepthOfThePictureToTheBit) {
  const bool reversed = GetParam();
  Scene scene(Asset::built_in());
  scene.set_transform(scene.instances().front(),
                      {0.8, 0, 0.6, 0, 0, 1, 0, 0, -0.6, 0, 0.8, 0, 0.01, -0.02, -0.1, 1});
  Frame plain({.options = picture_and_depth(reversed)}), with({.options = picture_and_depth(reversed)});
  plain.frames->update(scene, frame_settings());
  with.frames->update(scene, frame_settings());

  plain.draw();
  with.draw([&](VkCommandBuffer commands) {
    with.frames->record_depth(commands, vulkan::clip_from_world(front_camera(reversed)), pre_pass(with));
  });
  EXPECT_EQ(with.depth_values(), plain.depth_values());
  EXPECT_EQ(with.colour().rgba, plain.colour().rgba);
}
INSTANTIATE_TEST_SUITE_P(Reversed, EmbeddedDepthByDirection, testing::Bool());

TEST_F(EmbeddedDepth, DrawsWithoutAFrameAndLeavesOutWhatIsHidden) {
  Frame frame({.options = {.depths = {vulkan::DepthTargets{}}}});
  Scene scene = lit_ball();
  const auto drawn = [&] {
    frame.frames->update(scene, frame_settings());
    frame.host.run([&](VkCommandBuffer commands) {
      frame.host.transition(commands, frame.depth_image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
      frame.host.clear(commands, nullptr, {}, &frame.depth_image, 0, {{0, 0}, {side, side}});
      frame.frames->record_depth(commands, vulkan::clip_from_world(front_camera()), pre_pass(frame));
    });
    const std::vector<float> depth = frame.depth_values();
    return std::count_if(depth.begin(), depth.end(), [](float d) { return d > 0; });
  };

  // A ball of 0.07 m at 0.4 m covers a disc of tan(asin(0.07 / 0.4)) / 0.25 halves of the picture.
  const double radius = 0.1778 / 0.25 * side / 2;
  EXPECT_NEAR(static_cast<double>(drawn()), 3.1416 * radius * radius, 60);
  scene.set_visible(scene.instances().front(), false);
  EXPECT_EQ(drawn(), 0);
}

// Upside down: the same matrix with clip y upwards is the picture turned about its middle row.
TEST_F(EmbeddedDepth, ClipYMayGrowUpwards) {
  Frame frame({.options = {.depths = {vulkan::DepthTargets{}}}});
  Scene scene(Asset::built_in());
  frame.frames->update(scene, frame_settings());
  const auto drawn = [&](bool y_down) {
    frame.host.run([&](VkCommandBuffer commands) {
      frame.host.transition(commands, frame.depth_image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
      frame.host.clear(commands, nullptr, {}, &frame.depth_image, 0, {{0, 0}, {side, side}});
      vulkan::DepthView view = pre_pass(frame);
      view.y_down = y_down;
      view.cull = false;
      std::array<double, 16> matrix = vulkan::clip_from_world(front_camera());
      if (!y_down)
        for (std::size_t column = 0; column < 4; ++column) matrix[4 * column + 1] *= -1;
      frame.frames->record_depth(commands, matrix, view);
    });
    return frame.depth_values();
  };
  EXPECT_EQ(drawn(true), drawn(false));
}

}  // namespace
}  // namespace dermis::tests
