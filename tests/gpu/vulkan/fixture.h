// SPDX-License-Identifier: MIT
// What the tests of this folder share: a validated device, and the promise that the validation layer stays
// silent.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "dermis/error.h"
#include "gpu/cmd.h"
#include "gpu/device.h"
#include "gpu/pipelines.h"
#include "gpu/resources.h"

namespace dermis::test_vulkan {
std::span<const std::uint32_t> find_shader(std::string_view name);
}

namespace dermis::gpu {

/// A device of our own for each test, with the validation layer where it is installed. Skips where there is
/// no device.
class GpuTest : public testing::Test {
 protected:
  void SetUp() override {
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty()) GTEST_SKIP() << "no Vulkan device (Debian, Ubuntu: apt install mesa-vulkan-drivers)";
    // Devices of which none serves would turn every test off unseen, so that is a failure.
    for (const std::string& missing : devices[0].missing) ADD_FAILURE() << devices[0].name << ": " << missing;
    if (HasFailure()) return;
    try {
      device_ = std::make_unique<Device>(Device::Options{.select = "best", .validate = true});
    } catch (const DeviceError& error) {
      if (!std::string_view(error.what()).starts_with("validation needs")) throw;
      device_ = std::make_unique<Device>(Device::Options{});
    }
    library_ = std::make_unique<PipelineLibrary>(*device_, test_vulkan::find_shader);
  }

  void TearDown() override {
    library_.reset();
    if (device_) { EXPECT_EQ(device_->validation_messages(), std::vector<std::string>{}); }
  }

  Device& device() { return *device_; }
  PipelineLibrary& library() { return *library_; }

  /// A whole-image transition that waits for everything.
  static void transition(Cmd& cmd, const Texture& texture, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier2 image{};
    image.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    image.srcStageMask = image.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    image.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    image.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    image.oldLayout = from;
    image.newLayout = to;
    image.srcQueueFamilyIndex = image.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    image.image = texture.handle();
    image.subresourceRange = {aspect_of(texture.desc().format), 0, VK_REMAINING_MIP_LEVELS, 0,
                              VK_REMAINING_ARRAY_LAYERS};
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &image;
    cmd.barrier(info);
  }

  template <class T>
  std::vector<T> values_of(const Buffer& buffer) {
    return as<T>(read_back(device(), buffer));
  }
  template <class T>
  static std::vector<T> as(const std::vector<std::byte>& bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
  }

 private:
  std::unique_ptr<Device> device_;
  std::unique_ptr<PipelineLibrary> library_;
};

template <class T>
std::uint32_t bits(T value) {
  static_assert(sizeof(T) == 4);
  std::uint32_t result = 0;
  std::memcpy(&result, &value, 4);
  return result;
}

}  // namespace dermis::gpu
