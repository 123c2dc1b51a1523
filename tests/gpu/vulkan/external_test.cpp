// SPDX-License-Identifier: MIT
// An engine with its own instance, device, queue and command buffers uses the library for a part of its
// frame.
#include <array>
#include <optional>

#include "fixture.h"
#include "gpu/support/host.h"
#include "gpu/timer.h"

namespace dermis::gpu {
namespace {

struct FillPushIo {
  float weights[3];
  std::uint32_t count;
};

/// Records one dispatch that writes 1 * 100 + 2 * 10 + 3 per element.
void record_fill(Device& device, PipelineLibrary& library, VkCommandBuffer commands, const Buffer& in,
                 const Buffer& out) {
  Cmd cmd(device, commands);
  const Pipeline& fill = library.compute("fill.comp");
  cmd.bind(fill, std::array<Binding, 2>{BufferBinding{&in}, BufferBinding{&out}});
  cmd.push(fill, FillPushIo{{100, 10, 1}, 4});
  cmd.dispatch_over(fill, 4, 1);
}

class External : public testing::Test {
 protected:
  void SetUp() override {
    if (list_devices().empty())
      GTEST_SKIP() << "no Vulkan device (Debian, Ubuntu: apt install mesa-vulkan-drivers)";
    engine_.emplace();
  }
  void TearDown() override {
    if (!engine_) return;
    EXPECT_EQ(engine_->messages(), std::vector<std::string>{});
  }
  static constexpr float numbers[] = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
  std::optional<tests::Host> engine_;
};

TEST_F(External, RecordsIntoTheEnginesCommandsAndSubmitsNothing) {
  tests::Host& engine = *engine_;
  {
    Device device(engine.vulkan());
    PipelineLibrary library(device, test_vulkan::find_shader);
    const Buffer in = make_buffer<float>(device, "in", numbers, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const Buffer out(device, "out", {.bytes = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    Timer timer(device, 1);
    device.run([&](VkCommandBuffer commands) { Cmd(device, commands).fill(out, 0); });

    std::vector<float> values(4);
    engine.run([&](VkCommandBuffer commands) {
      timer.reset(commands);
      timer.begin(commands, "fill");
      device.begin_label(commands, "fill");
      record_fill(device, library, commands, in, out);
      device.end_label(commands);
      timer.end(commands);

      std::memcpy(values.data(), read_back(device, out).data(), 16);
      EXPECT_EQ(values, std::vector<float>(4, 0.0f));  // recorded, not submitted
    });

    std::memcpy(values.data(), read_back(device, out).data(), 16);
    EXPECT_EQ(values, std::vector<float>(4, 123.0f));
    EXPECT_EQ(timer.read().size(), 1u);
    EXPECT_TRUE(device.validation_messages().empty());
  }
  // The engine's device is still its own.
  EXPECT_EQ(engine.vk().vkDeviceWaitIdle(engine.vulkan().device), VK_SUCCESS);
}

TEST_F(External, RetiredObjectsLiveUntilTheFrameHasFinished) {
  tests::Host& engine = *engine_;
  Device device(engine.vulkan());
  PipelineLibrary library(device, test_vulkan::find_shader);
  const Buffer out(device, "out", {.bytes = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  Buffer in = make_buffer<float>(device, "in", numbers, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const std::uint64_t held = device.buffer_bytes();
  device.begin_host_frame(1, 0);
  engine.run([&](VkCommandBuffer commands) {
    record_fill(device, library, commands, in, out);
    in = {};
    device.run([&](VkCommandBuffer) {});  // a submission of ours tells nothing about the engine's
    EXPECT_EQ(device.buffer_bytes(), held);
  });
  EXPECT_EQ(device.buffer_bytes(), held);
  device.begin_host_frame(2, 1);
  EXPECT_LT(device.buffer_bytes(), held);
}

TEST_F(External, SharesTheProcessWithADeviceOfOurs) {
  Device theirs(engine_->vulkan());
  Device ours(Device::Options{});
  for (Device* device : {&theirs, &ours, &theirs}) {
    PipelineLibrary library(*device, test_vulkan::find_shader);
    const Buffer in = make_buffer<float>(*device, "in", numbers, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const Buffer out(*device, "out", {.bytes = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    device->run([&](VkCommandBuffer commands) { record_fill(*device, library, commands, in, out); });
    std::vector<float> values(4);
    std::memcpy(values.data(), read_back(*device, out).data(), 16);
    EXPECT_EQ(values, std::vector<float>(4, 123.0f));
  }
}

}  // namespace
}  // namespace dermis::gpu
