// SPDX-License-Identifier: MIT
// An engine with its own instance, device, queue and command buffers uses the library for a part of its
// frame.
#include <array>

#include "fixture.h"
#include "gpu/loader.h"
#include "gpu/timer.h"

namespace dermis::gpu {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL count_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                             VkDebugUtilsMessageTypeFlagsEXT type,
                                             const VkDebugUtilsMessengerCallbackDataEXT* data,
                                             void* messages) {
  if (type & VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT)
    static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  return VK_FALSE;
}

/// What an engine would have, made without this library but for RequiredFeatures.
class Engine {
 public:
  explicit Engine(PFN_vkGetInstanceProcAddr get) : get_(get) {
    const auto global = [&]<class F>(F& f, const char* name) {
      f = reinterpret_cast<F>(get(VK_NULL_HANDLE, name));
    };
    PFN_vkCreateInstance create_instance{};
    global(create_instance, "vkCreateInstance");
    VkDebugUtilsMessengerCreateInfoEXT messenger{};
    messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    messenger.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    messenger.pfnUserCallback = count_message;
    messenger.pUserData = &messages;
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = RequiredFeatures::api_version;
    const char* layer = "VK_LAYER_KHRONOS_validation";
    const char* debug_utils = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pNext = &messenger;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &layer;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &debug_utils;
    // works without the layer too, with less to see
    if (create_instance(&info, nullptr, &instance) == VK_ERROR_LAYER_NOT_PRESENT) {
      info.pNext = nullptr;
      info.enabledLayerCount = info.enabledExtensionCount = 0;
      EXPECT_EQ(create_instance(&info, nullptr, &instance), VK_SUCCESS);
    }
    if (info.enabledLayerCount) {
      PFN_vkCreateDebugUtilsMessengerEXT create_messenger{};
      load(create_messenger, "vkCreateDebugUtilsMessengerEXT");
      EXPECT_EQ(create_messenger(instance, &messenger, nullptr, &messenger_), VK_SUCCESS);
    }
    make_device();
  }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  ~Engine() {
    vk.vkDestroyFence(device, fence, nullptr);
    vk.vkDestroyCommandPool(device, pool, nullptr);
    vk.vkDestroyDevice(device, nullptr);
    PFN_vkDestroyDebugUtilsMessengerEXT destroy_messenger{};
    load(destroy_messenger, "vkDestroyDebugUtilsMessengerEXT");
    if (messenger_) destroy_messenger(instance, messenger_, nullptr);
    PFN_vkDestroyInstance destroy{};
    load(destroy, "vkDestroyInstance");
    destroy(instance, nullptr);
  }

  vulkan::Host host() const {
    return {.get_instance_proc_addr = get_,
            .instance = instance,
            .physical_device = physical,
            .device = device,
            .queue = queue};
  }
  void begin() {
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    EXPECT_EQ(vk.vkBeginCommandBuffer(commands, &info), VK_SUCCESS);
  }
  void submit_and_wait() {
    EXPECT_EQ(vk.vkEndCommandBuffer(commands), VK_SUCCESS);
    VkSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands;
    EXPECT_EQ(vk.vkQueueSubmit(queue, 1, &info, fence), VK_SUCCESS);
    EXPECT_EQ(vk.vkWaitForFences(device, 1, &fence, VK_TRUE, UINT64_MAX), VK_SUCCESS);
    EXPECT_EQ(vk.vkResetFences(device, 1, &fence), VK_SUCCESS);
  }

  std::vector<std::string> messages;
  VkInstance instance = VK_NULL_HANDLE;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  VkCommandPool pool = VK_NULL_HANDLE;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  VkFence fence = VK_NULL_HANDLE;
  DeviceTable vk{};

 private:
  template <class F>
  void load(F& function, const char* name) {
    function = reinterpret_cast<F>(get_(instance, name));
  }
  void make_device() {
    PFN_vkEnumeratePhysicalDevices enumerate{};
    load(enumerate, "vkEnumeratePhysicalDevices");
    std::uint32_t one = 1;
    enumerate(instance, &one, &physical);
    const float priority = 1;
    VkDeviceQueueCreateInfo queue_info{};
    queue_info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    const RequiredFeatures required;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &required.features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue_info;
    info.enabledExtensionCount = static_cast<std::uint32_t>(RequiredFeatures::extensions().size());
    info.ppEnabledExtensionNames = RequiredFeatures::extensions().data();
    PFN_vkCreateDevice create{};
    load(create, "vkCreateDevice");
    ASSERT_EQ(create(physical, &info, nullptr, &device), VK_SUCCESS);
    PFN_vkGetDeviceProcAddr get_device{};
    load(get_device, "vkGetDeviceProcAddr");
    vk = load_device_table(get_device, device);
    vk.vkGetDeviceQueue(device, 0, 0, &queue);
    VkCommandPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    ASSERT_EQ(vk.vkCreateCommandPool(device, &pool_info, nullptr, &pool), VK_SUCCESS);
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool;
    allocate.commandBufferCount = 1;
    ASSERT_EQ(vk.vkAllocateCommandBuffers(device, &allocate, &commands), VK_SUCCESS);
    VkFenceCreateInfo fence_info{};
    fence_info.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    ASSERT_EQ(vk.vkCreateFence(device, &fence_info, nullptr, &fence), VK_SUCCESS);
  }
  PFN_vkGetInstanceProcAddr get_;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

struct FillPush {
  float weights[3];
  std::uint32_t count;
};

/// Records one dispatch that writes 1 * 100 + 2 * 10 + 3 per element.
void record_fill(Device& device, PipelineLibrary& library, VkCommandBuffer commands, const Buffer& in,
                 const Buffer& out) {
  Cmd cmd(device, commands);
  const Pipeline& fill = library.compute("fill.comp");
  cmd.bind(fill, std::array<Binding, 2>{BufferBinding{&in}, BufferBinding{&out}});
  cmd.push(fill, FillPush{{100, 10, 1}, 4});
  cmd.dispatch_over(fill, 4, 1);
}

class External : public testing::Test {
 protected:
  void SetUp() override {
    if (list_devices().empty())
      GTEST_SKIP() << "no Vulkan device (Debian, Ubuntu: apt install mesa-vulkan-drivers)";
    engine_ = std::make_unique<Engine>(open_loader());
  }
  void TearDown() override {
    if (!engine_) return;
    EXPECT_EQ(engine_->messages, std::vector<std::string>{});
  }
  static constexpr float numbers[] = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
  std::unique_ptr<Engine> engine_;
};

TEST_F(External, RecordsIntoTheEnginesCommandsAndSubmitsNothing) {
  Engine& engine = *engine_;
  {
    Device device(engine.host());
    PipelineLibrary library(device, test_vulkan::find_shader);
    const Buffer in = make_buffer<float>(device, "in", numbers, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const Buffer out(device, "out", {.bytes = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    Timer timer(device, 1);
    device.run([&](VkCommandBuffer commands) { Cmd(device, commands).fill(out, 0); });

    engine.begin();
    timer.reset(engine.commands);
    timer.begin(engine.commands, "fill");
    device.begin_label(engine.commands, "fill");
    record_fill(device, library, engine.commands, in, out);
    device.end_label(engine.commands);
    timer.end(engine.commands);

    std::vector<float> values(4);
    std::memcpy(values.data(), read_back(device, out).data(), 16);
    EXPECT_EQ(values, std::vector<float>(4, 0.0f));  // recorded, not submitted

    engine.submit_and_wait();
    std::memcpy(values.data(), read_back(device, out).data(), 16);
    EXPECT_EQ(values, std::vector<float>(4, 123.0f));
    EXPECT_EQ(timer.read().size(), 1u);
    EXPECT_TRUE(device.validation_messages().empty());
  }
  EXPECT_EQ(engine.vk.vkDeviceWaitIdle(engine.device), VK_SUCCESS);  // the engine's device is still its own
}

TEST_F(External, RetiredObjectsLiveUntilTheFrameHasFinished) {
  Engine& engine = *engine_;
  Device device(engine.host());
  PipelineLibrary library(device, test_vulkan::find_shader);
  const Buffer out(device, "out", {.bytes = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  Buffer in = make_buffer<float>(device, "in", numbers, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const std::uint64_t held = device.buffer_bytes();
  device.begin_host_frame(1, 0);
  engine.begin();
  record_fill(device, library, engine.commands, in, out);
  in = {};
  device.run([&](VkCommandBuffer) {});  // a submission of ours tells nothing about the engine's
  EXPECT_EQ(device.buffer_bytes(), held);
  engine.submit_and_wait();
  EXPECT_EQ(device.buffer_bytes(), held);
  device.begin_host_frame(2, 1);
  EXPECT_LT(device.buffer_bytes(), held);
}

TEST_F(External, SharesTheProcessWithADeviceOfOurs) {
  Device theirs(engine_->host());
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
