// SPDX-License-Identifier: MIT
#include "gpu/device.h"

#include <array>
#include <cstdio>
#include <cstdlib>

#include "fixture.h"
#include "gpu/choose.h"
#include "gpu/instance.h"

namespace dermis::gpu {
namespace {

using Devices = GpuTest;

std::string refusal(const std::function<void()>& action) {
  try {
    action();
    return "";
  } catch (const DeviceError& error) { return error.what(); }
}

/// Prints what a device without the given environment says, and ends this (child) process with 1.
[[noreturn]] void without_drivers() {
  setenv("VK_DRIVER_FILES", "/nonexistent", 1);
  setenv("VK_ICD_FILENAMES", "/nonexistent", 1);
  const bool none = list_devices().empty();
  std::fprintf(stderr, "%s: %s\n", none ? "none" : "some",
               refusal([] { const Device device(Device::Options{}); }).c_str());
  std::exit(1);
}

TEST(NoDriverDeathTest, SaysWhatToInstall) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(without_drivers(), testing::ExitedWithCode(1),
              "none: no Vulkan driver found.*1.3.*apt install mesa-vulkan-drivers");
}

TEST(NoLoader, SaysWhatToInstall) {
  EXPECT_EQ(open_loader("libvulkan-of-nowhere.so.1"), nullptr);
  const std::string said = refusal([] { const Instance instance(false, "libvulkan-of-nowhere.so.1"); });
  EXPECT_EQ(said,
            "no Vulkan loader (libvulkan-of-nowhere.so.1): install it and a driver (Debian, Ubuntu: apt "
            "install libvulkan1 mesa-vulkan-drivers)");
}

TEST_F(Devices, AreListedWithWhatThereIsToKnow) {
  const auto devices = list_devices();
  ASSERT_FALSE(devices.empty());
  for (const DeviceInfo& d : devices) {
    EXPECT_FALSE(d.name.empty());
    EXPECT_EQ(d.api.find("1."), 0u) << d.api;
    EXPECT_GT(d.memory_bytes, 1u << 20);
    const std::array<std::string, 5> types{"discrete", "integrated", "virtual", "software", "other"};
    EXPECT_NE(std::ranges::find(types, d.type), types.end()) << d.type;
  }
  EXPECT_EQ(device().summary().name, devices[0].name);
  EXPECT_EQ(Device(Device::Options{.select = "0"}).summary().name, devices[0].name);
}

TEST_F(Devices, WrongNameListsTheKnownOnes) {
  const std::string said = refusal([] { const Device d(Device::Options{.select = "no such card"}); });
  EXPECT_EQ(said.find("no device 'no such card'; there are: 0: " + list_devices()[0].name), 0u) << said;
}

TEST_F(Devices, LimitsAreThoseOfVulkan) {
  const DeviceLimits& limits = device().limits();
  EXPECT_GE(limits.max_image_side, 4096u);
  EXPECT_GE(limits.max_array_layers, 256u);
  EXPECT_GE(limits.max_push_bytes, 128u);
  EXPECT_GE(limits.max_clip_distances, 8u);
  EXPECT_GE(limits.max_storage_buffer_bytes, 1u << 27);
  EXPECT_TRUE(device().format_supports(VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT));
  EXPECT_FALSE(device().format_supports(VK_FORMAT_D32_SFLOAT, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT));
}

TEST_F(Devices, ErrorsNameTheCall) {
  EXPECT_EQ(refusal([] { check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "vkThing"); }),
            "vkThing: out of device memory (VkResult -2)");
  EXPECT_EQ(refusal([] { check(VK_SUCCESS, "vkThing"); }), "");
}

TEST_F(Devices, RefuseWhatIsTooLarge) {
  const std::uint32_t side = device().limits().max_image_side;
  constexpr VkImageUsageFlags sampled = VK_IMAGE_USAGE_SAMPLED_BIT;
  const auto texture = [&](const TextureDesc& desc) {
    return refusal([&] { const Texture made(device(), "map", desc); });
  };

  EXPECT_NE(texture({.width = 100000, .height = 8, .format = VK_FORMAT_R8_UNORM, .usage = sampled})
                .find("'map' would be 100000x8 texels"),
            std::string::npos);
  EXPECT_NE(texture({.width = 8, .height = side + 1, .format = VK_FORMAT_R8_UNORM, .usage = sampled})
                .find("per side"),
            std::string::npos);
  EXPECT_NE(
      texture({.width = 8, .height = 8, .layers = 1u << 20, .format = VK_FORMAT_R8_UNORM, .usage = sampled})
          .find("1048576 layers"),
      std::string::npos);
  EXPECT_NE(texture({.width = 8,
                     .height = 8,
                     .format = VK_FORMAT_D32_SFLOAT,
                     .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT})
                .find("needs D32_SFLOAT images"),
            std::string::npos);

  const std::string huge = texture({.width = side,
                                    .height = side,
                                    .layers = 256,
                                    .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                    .usage = sampled});
  EXPECT_NE(huge.find("no device memory for 'map': needed "), std::string::npos) << huge;

  const std::uint64_t over = device().limits().max_storage_buffer_bytes + 4;
  if (over <= device().limits().max_buffer_bytes) {
    const std::string said = refusal([&] {
      const Buffer b(device(), "list", {.bytes = over, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    });
    EXPECT_NE(said.find("'list' would be"), std::string::npos) << said;
  }

  EXPECT_EQ(device().image_bytes() + device().buffer_bytes(), 0u);
}

TEST_F(Devices, RetireWaitsForWhatWasRecorded) {
  int freed = 0;
  device().retire([&] { ++freed; });
  EXPECT_EQ(freed, 1);  // nothing is in flight
  VkCommandBuffer commands = device().begin();
  device().retire([&] { ++freed; });
  EXPECT_EQ(freed, 1);
  const std::uint64_t serial = device().submit(commands);
  device().wait(serial);
  EXPECT_EQ(freed, 2);
  // One that retires another is served too.
  commands = device().begin();
  device().retire([&] { device().retire([&] { freed += 10; }); });
  device().wait(device().submit(commands));
  EXPECT_EQ(freed, 12);
}

TEST_F(Devices, DiscardedCommandsHoldNothing) {
  int freed = 0;
  EXPECT_THROW(device().run([&](VkCommandBuffer) {
    device().retire([&] { ++freed; });
    throw DeviceError("stop");
  }),
               DeviceError);
  EXPECT_EQ(freed, 0);
  device().begin_host_frame(0, 0);  // looks for what has completed
  EXPECT_EQ(freed, 1);
}

TEST_F(Devices, BuffersOutliveTheirNamesUntilTheGpuIsDone) {
  const std::uint32_t values[] = {1, 2, 3, 4};
  Buffer from = make_buffer<std::uint32_t>(device(), "from", values, 0);
  const Buffer to(device(), "to", {.bytes = sizeof(values)});
  VkCommandBuffer commands = device().begin();
  Cmd(device(), commands).copy(from, to, sizeof(values));
  const std::uint64_t before = device().buffer_bytes();
  from = {};
  EXPECT_EQ(device().buffer_bytes(), before);
  device().wait(device().submit(commands));
  EXPECT_LT(device().buffer_bytes(), before);
  EXPECT_EQ(values_of<std::uint32_t>(to), (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(Validation, SeesWhatIsWrong) {
  std::unique_ptr<Device> validated;
  try {
    validated = std::make_unique<Device>(Device::Options{.validate = true});
  } catch (const DeviceError& error) { GTEST_SKIP() << error.what(); }
  EXPECT_EQ(validated->validation_messages(), std::vector<std::string>{});
  const Buffer a(*validated, "buffer A", {.bytes = 64}), b(*validated, "buffer B", {.bytes = 64});
  validated->run([&](VkCommandBuffer commands) {
    Cmd cmd(*validated, commands);
    cmd.copy(a, b, 64);
    // reads what was just written, without a barrier: only synchronization validation sees it
    cmd.copy(b, a, 64);
  });
  ASSERT_FALSE(validated->validation_messages().empty());
  EXPECT_NE(validated->validation_messages()[0].find("SYNC-HAZARD-READ-AFTER-WRITE"), std::string::npos)
      << validated->validation_messages()[0];
}

}  // namespace
}  // namespace dermis::gpu
