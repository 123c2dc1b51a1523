// SPDX-License-Identifier: MIT
// Way (i): heads drawn into the colour and depth of a host are those of the renderer's own picture.
#include <fmt/format.h>

#include <array>
#include <set>

#include "frame.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/settings.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

using Embedding = WithHost;

TEST_F(Embedding, IsNotForThePublishedTechnique) {
  Frame frame;
  RenderSettings settings = frame_settings();
  settings.technique = "published";
  const std::string said = thrown<InputError>([&] { frame.frames->update(lit_ball(), settings); });
  EXPECT_NE(said.find("draws no frames of a host; take texture-space"), std::string::npos) << said;
}

TEST_F(Embedding, DepthMayGrowWithTheDistance) {
  Frame frame({.options = {.picture = vulkan::PictureTargets{.reversed_depth = false}}});
  const Scene scene = lit_ball();
  frame.frames->update(scene, frame_settings());
  frame.draw();
  EXPECT_LE(largest_difference(frame.colour(), rendered(scene, frame_settings(), false)), target_rounding());

  // The front of the ball is 0.33 m away: far (z - near) / (z (far - near)).
  const std::vector<float> depth = frame.depth_values();
  EXPECT_NEAR(depth[side / 2 * side + side / 2], 10 * (0.33 - 0.1) / (0.33 * 9.9), 1e-3);
  EXPECT_EQ(depth.front(), 1);
}

// Something of the host's stands in front of the left half, at the near plane.
TEST_F(Embedding, HeadsHideBehindWhatTheHostHasDrawn) {
  Frame frame;
  const Scene scene = lit_ball();
  frame.frames->update(scene, frame_settings());
  frame.draw([&](VkCommandBuffer commands) {
    frame.host.clear(commands, &frame.colour_image, {7, 7, 7, 0}, &frame.depth_image, 1,
                     {{0, 0}, {side / 2, side}});
  });

  const Pixels found = frame.colour(), wanted = rendered(scene, frame_settings());
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const float hidden = c < 3 ? 7 : 0, value = x < side / 2 ? hidden : wanted.at(x, y)[c];
        const double share = x < side / 2 || on_software() ? 0 : target_rounding();
        ASSERT_NEAR(found.at(x, y)[c], value, share * double{value}) << x << ", " << y;
      }
}

std::string text_of(const DeviceCounters& c) {
  return fmt::format("{} allocations, {} buffers, {} images, {} pipelines, {} submissions, {} waits",
                     c.allocations, c.buffers, c.images, c.pipelines, c.submissions, c.waits);
}

// Camera, pose, light, exposure and the size of the picture change in every frame.
TEST_F(Embedding, ASteadyFrameAsksTheDeviceForNothing) {
  Frame frame({.options = {.picture = vulkan::PictureTargets{}, .scattered = true}});
  Scene scene = lit_ball();
  RenderSettings settings = frame_settings();
  DeviceCounters before;
  for (int i = 0; i < 20; ++i) {
    if (i == 2) before = frame.renderer->counters();
    scene.set_transform(scene.instances().front(),
                        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.001 * i, 0, -0.02 * i, 1});
    scene.set_light(scene.lights().front(), {.light = {.direction = {0.1 * i - 1, -0.5, -0.7}}});
    settings.output.exposure_ev = 0.1 * i;
    frame.frames->update(scene, settings);
    frame.draw({}, {{0, 0}, {side - std::uint32_t(i), side}});
  }
  EXPECT_EQ(text_of(frame.renderer->counters()), text_of(before));
}

// A frame of the renderer's own afterwards: nothing of the host's is left in it.
TEST_F(Embedding, TheRendererStillDrawsItsOwnPictures) {
  Frame frame;
  const Scene scene = lit_ball();
  RenderSettings settings = frame_settings();
  settings.camera.matrices = front_camera();
  frame.frames->update(scene, settings);
  frame.draw();
  expect_equal_bits(tests::renderer().render(scene, settings), frame.renderer->render(scene, settings));
  frame.draw();
  EXPECT_LE(largest_difference(frame.colour(), rendered(scene, frame_settings())), target_rounding());
}

// Counts what a host's allocator hands out.
struct Allocator {
  explicit Allocator(const Host& wanted) : host(&wanted), device(wanted.vulkan().device) {
    PFN_vkGetPhysicalDeviceMemoryProperties get{};
    get = reinterpret_cast<decltype(get)>(wanted.vulkan().get_instance_proc_addr(
        wanted.vulkan().instance, "vkGetPhysicalDeviceMemoryProperties"));
    get(wanted.vulkan().physical_device, &types);
  }

  std::optional<vulkan::MemoryRange> allocate(const vulkan::MemoryRequest& request) {
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    // An offset, to see that it is used.
    const VkDeviceSize offset = request.dedicated ? 0 : request.requirements.alignment;
    info.allocationSize = request.requirements.size + offset;
    while (!(request.requirements.memoryTypeBits >> info.memoryTypeIndex & 1u)) ++info.memoryTypeIndex;
    vulkan::MemoryRange range{.offset = offset};
    if (host->vk().vkAllocateMemory(device, &info, nullptr, &range.memory) != VK_SUCCESS) return {};
    if (request.mapped) {
      void* start = nullptr;
      host->vk().vkMapMemory(device, range.memory, 0, VK_WHOLE_SIZE, 0, &start);
      range.mapped = static_cast<std::byte*>(start) + offset;
    }
    live.insert(range.memory);
    ++made;
    return range;
  }
  void free(const vulkan::MemoryRange& range) {
    EXPECT_EQ(live.erase(range.memory), 1u);
    host->vk().vkFreeMemory(device, range.memory, nullptr);
  }

  const Host* host;
  VkDevice device;
  VkPhysicalDeviceMemoryProperties types{};
  std::set<VkDeviceMemory> live;
  int made = 0;
};

TEST_F(Embedding, TheHostAllocatesAndGetsEverythingBack) {
  Host host;
  Allocator allocator(host);
  const Scene scene = lit_ball();
  RenderSettings settings = frame_settings();
  settings.camera.matrices = front_camera();
  {
    vulkan::Host with_memory = host.vulkan();
    with_memory.memory = {.allocate = [&](const auto& request) { return allocator.allocate(request); },
                          .free = [&](const auto& range) { allocator.free(range); }};
    Renderer renderer(with_memory);
    expect_equal_bits(tests::renderer().render(scene, settings), renderer.render(scene, settings));
    EXPECT_GT(allocator.made, 20);
    EXPECT_EQ(renderer.counters().allocations, static_cast<std::uint64_t>(allocator.made));
  }
  EXPECT_TRUE(allocator.live.empty()) << allocator.live.size() << " ranges";
  EXPECT_EQ(host.messages(), std::vector<std::string>{});
}

TEST_F(Embedding, AHostsPipelineCacheIsUsedAndStaysItsOwn) {
  Host host;
  const VkDevice device = host.vulkan().device;
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  VkPipelineCache cache = VK_NULL_HANDLE;
  ASSERT_EQ(host.vk().vkCreatePipelineCache(device, &info, nullptr, &cache), VK_SUCCESS);
  const auto bytes = [&] {
    std::size_t size = 0;
    host.vk().vkGetPipelineCacheData(device, cache, &size, nullptr);
    return size;
  };
  const std::size_t empty = bytes();
  {
    vulkan::Host with_cache = host.vulkan();
    with_cache.pipeline_cache = cache;
    Renderer renderer(with_cache);
    renderer.render(lit_ball(), frame_settings());
  }
  EXPECT_GE(bytes(), empty);
  host.vk().vkDestroyPipelineCache(device, cache, nullptr);
  EXPECT_EQ(host.messages(), std::vector<std::string>{});
}

}  // namespace
}  // namespace dermis::tests
