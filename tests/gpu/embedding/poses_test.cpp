// SPDX-License-Identifier: MIT
// Instances in poses, in the frames of a host: as in the renderer's own picture.
#include <fmt/format.h>

#include "frame.h"
#include "gpu/support/pictures.h"

namespace dermis::tests {
namespace {

using EmbeddedPoses = WithHost;

// The built-in head has skin, eyes, teeth and hair, which all move.
Scene head() {
  Scene scene;
  const InstanceId id = scene.add({.asset = Asset::built_in()});
  scene.set_transform(id, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.1, 1});
  scene.add_light({.light = {.colour = {3, 3, 3}, .direction = {-0.5, -0.5, -0.7}}});
  return scene;
}

RenderSettings in_the_studio() {
  RenderSettings settings = frame_settings();
  settings.lighting.environment = "studio";
  return settings;
}

// Hair is blended into the skin of a host's target, and over that of a picture: a rounding more.
TEST_F(EmbeddedPoses, EqualTheRenderersPicture) {
  Frame frame({.options = {.picture = vulkan::PictureTargets{}, .depths = {vulkan::DepthTargets{}}}});
  const RenderSettings settings = in_the_studio();
  Scene scene = head();
  const InstanceId id = scene.instances().front();
  const Pixels rest = rendered(scene, settings);
  for (const double seconds : {0.5, 1.5}) {
    scene.pose(id, "life", seconds);
    frame.frames->update(scene, settings);
    frame.draw();
    const Pixels wanted = rendered(scene, settings);
    EXPECT_LE(largest_difference(frame.colour(), wanted), 2 * half_rounding) << seconds;
    EXPECT_GE(largest_difference(rest, wanted), 0.05) << "this pose moves nothing";
  }

  scene.set_pose(id, {});
  frame.frames->update(scene, settings);
  frame.draw();
  EXPECT_LE(largest_difference(frame.colour(), rest), 2 * half_rounding);
}

// The depth pre-pass comes first, and moves the head for both.
TEST_F(EmbeddedPoses, HaveOneDepth) {
  const vulkan::HostFrames::Options options{.picture = vulkan::PictureTargets{},
                                            .depths = {vulkan::DepthTargets{}}};
  Frame plain({.options = options}), with({.options = options});
  Scene scene = head();
  std::vector<float> last;
  for (const double seconds : {0.5, 1.5}) {
    scene.pose(scene.instances().front(), "life", seconds);
    plain.frames->update(scene, in_the_studio());
    with.frames->update(scene, in_the_studio());
    plain.draw();
    with.draw([&](VkCommandBuffer commands) {
      with.frames->record_depth(commands, vulkan::clip_from_world(front_camera()),
                                {.depth = with.depth_image.view, .extent = {side, side}, .cull = true});
    });
    EXPECT_EQ(with.depth_values(), plain.depth_values()) << seconds;
    EXPECT_EQ(with.colour().rgba, plain.colour().rgba) << seconds;
    EXPECT_NE(with.depth_values(), last) << "this pose moves nothing";
    last = with.depth_values();
  }
}

TEST_F(EmbeddedPoses, AskTheDeviceForNothing) {
  Frame frame;
  Scene scene = head();
  DeviceCounters before;
  for (int i = 0; i < 8; ++i) {
    if (i == 3) before = frame.renderer->counters();
    scene.pose(scene.instances().front(), "life", 0.2 * i);
    frame.frames->update(scene, in_the_studio());
    frame.draw();
  }
  const DeviceCounters after = frame.renderer->counters();
  EXPECT_EQ(after.allocations, before.allocations);
  EXPECT_EQ(after.buffers, before.buffers);
  EXPECT_EQ(after.images, before.images);
  EXPECT_EQ(after.pipelines, before.pipelines);
  EXPECT_EQ(after.submissions, before.submissions);
  EXPECT_EQ(after.waits, before.waits);
}

TEST_F(EmbeddedPoses, AreNotMovedByTheHostToo) {
  Frame frame;
  Scene scene = head();
  const InstanceId id = scene.instances().front();
  frame.frames->update(scene, frame_settings());
  scene.pose(id, "life", 1);
  EXPECT_THROW(frame.frames->update(scene, frame_settings(), {.deformed = {id}}), InputError);
  frame.draw();
}

}  // namespace
}  // namespace dermis::tests
