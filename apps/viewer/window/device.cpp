// SPDX-License-Identifier: MIT
// Vulkan's header comes first, so that GLFW's knows its types.
#include <vulkan/vulkan.h>
//
#include "viewer/window/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "dermis/error.h"

namespace dermis::viewer {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                            VkDebugUtilsMessageTypeFlagsEXT,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data,
                                            void* messages) {
  static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  return VK_FALSE;
}

bool has_validation_layer() {
  std::uint32_t count = 0;
  check(vkEnumerateInstanceLayerProperties(&count, nullptr), "vkEnumerateInstanceLayerProperties");
  std::vector<VkLayerProperties> layers(count);
  check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "vkEnumerateInstanceLayerProperties");
  return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, validation_layer) == 0;
  });
}

// The best first: what games run on, and software last.
int rank_of(VkPhysicalDevice device) {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(device, &properties);
  switch (properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    default: return 3;
  }
}

std::optional<std::uint32_t> family_of(VkPhysicalDevice device, VkSurfaceKHR surface) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());

  for (std::uint32_t i = 0; i < count; ++i) {
    VkBool32 presents = VK_FALSE;
    if (vkGetPhysicalDeviceSurfaceSupportKHR(device, i, surface, &presents) != VK_SUCCESS) continue;
    if (presents && (families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT)) return i;
  }
  return {};
}

}  // namespace

void check(VkResult result, const char* call) {
  if (result == VK_SUCCESS) return;
  if (result == VK_ERROR_SURFACE_LOST_KHR || result == VK_ERROR_DEVICE_LOST) throw SurfaceLost{};
  throw DeviceError(fmt::format("the window: {} failed with VkResult {}", call, static_cast<int>(result)));
}

PresentDevice::Handles::~Handles() {
  if (device) {
    vkDeviceWaitIdle(device);
    vkDestroyDevice(device, nullptr);
  }
  if (surface) vkDestroySurfaceKHR(instance, surface, nullptr);
  if (messenger) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance, messenger, nullptr);
  }
  if (instance) vkDestroyInstance(instance, nullptr);
}

PresentDevice::PresentDevice(GLFWwindow* window, bool validate, std::vector<std::string>& said) {
  make_instance(validate, said);
  check(glfwCreateWindowSurface(vk_.instance, window, nullptr, &vk_.surface), "glfwCreateWindowSurface");

  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(vk_.instance, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(vk_.instance, &count, devices.data()), "vkEnumeratePhysicalDevices");
  std::stable_sort(devices.begin(), devices.end(),
                   [](VkPhysicalDevice a, VkPhysicalDevice b) { return rank_of(a) < rank_of(b); });

  for (const VkPhysicalDevice physical : devices)
    if (try_device(physical)) return;
  throw DeviceError(
      fmt::format("no Vulkan 1.3 device can show pictures in this window, of {} there are; 'dermis render' "
                  "draws without a window",
                  count));
}

void PresentDevice::make_instance(bool validate, std::vector<std::string>& said) {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) throw DeviceError("no Vulkan driver can show a window here; 'dermis render' draws without one");
  std::vector<const char*> extensions(names, names + count);

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = VK_API_VERSION_1_3;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;

  // Chained to the instance, the messenger also hears what is said while that is made and destroyed.
  VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messenger.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  messenger.pfnUserCallback = keep_message;
  messenger.pUserData = &said;
  const bool under_layer = validate && has_validation_layer();
  if (under_layer) {
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    info.pNext = &messenger;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &validation_layer;
  }
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  check(vkCreateInstance(&info, nullptr, &vk_.instance), "vkCreateInstance");

  if (!under_layer) return;
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(vk_.instance, "vkCreateDebugUtilsMessengerEXT"));
  check(create(vk_.instance, &messenger, nullptr, &vk_.messenger), "vkCreateDebugUtilsMessengerEXT");
}

bool PresentDevice::try_device(VkPhysicalDevice physical) {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical, &properties);
  const std::optional<std::uint32_t> family = family_of(physical, vk_.surface);
  if (properties.apiVersion < VK_API_VERSION_1_3 || !family) return false;

  VkPhysicalDeviceVulkan13Features features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  features.dynamicRendering = VK_TRUE;
  features.synchronization2 = VK_TRUE;
  constexpr float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = *family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const char* const swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = 1;
  info.ppEnabledExtensionNames = &swapchain;
  if (vkCreateDevice(physical, &info, nullptr, &vk_.device) != VK_SUCCESS) return false;

  physical_ = physical;
  queue_family_ = *family;
  is_software_ = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  vkGetDeviceQueue(vk_.device, queue_family_, 0, &queue_);
  vkGetPhysicalDeviceMemoryProperties(physical, &memory_);
  return true;
}

Owned<VkDeviceMemory> PresentDevice::allocate(const VkMemoryRequirements& needs,
                                              VkMemoryPropertyFlags properties) const {
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = needs.size;
  while (info.memoryTypeIndex < memory_.memoryTypeCount &&
         (!(needs.memoryTypeBits >> info.memoryTypeIndex & 1u) ||
          (memory_.memoryTypes[info.memoryTypeIndex].propertyFlags & properties) != properties))
    ++info.memoryTypeIndex;
  if (info.memoryTypeIndex == memory_.memoryTypeCount) check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "memory type");

  VkDeviceMemory memory = VK_NULL_HANDLE;
  check(vkAllocateMemory(vk_.device, &info, nullptr, &memory), "vkAllocateMemory");
  return {vk_.device, memory, vkFreeMemory};
}

DeviceImage PresentDevice::make_image(VkExtent2D extent) const {
  DeviceImage made;
  made.extent = extent;
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  VkImage image = VK_NULL_HANDLE;
  check(vkCreateImage(vk_.device, &info, nullptr, &image), "vkCreateImage");
  made.image = {vk_.device, image, vkDestroyImage};

  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(vk_.device, image, &needs);
  made.memory = allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(vk_.device, image, made.memory.get(), 0), "vkBindImageMemory");

  VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view_info.image = image;
  view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view_info.format = info.format;
  view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(vk_.device, &view_info, nullptr, &view), "vkCreateImageView");
  made.view = {vk_.device, view, vkDestroyImageView};
  return made;
}

HostBuffer PresentDevice::make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) const {
  HostBuffer made;
  made.bytes = bytes;
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = usage;
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vkCreateBuffer(vk_.device, &info, nullptr, &buffer), "vkCreateBuffer");
  made.buffer = {vk_.device, buffer, vkDestroyBuffer};

  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(vk_.device, buffer, &needs);
  made.memory = allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  check(vkBindBufferMemory(vk_.device, buffer, made.memory.get(), 0), "vkBindBufferMemory");
  void* mapped = nullptr;
  check(vkMapMemory(vk_.device, made.memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
  made.mapped = static_cast<std::byte*>(mapped);
  return made;
}

}  // namespace dermis::viewer
