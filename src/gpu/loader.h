// SPDX-License-Identifier: MIT
// Function pointers per instance and per device. Fills no global ones: an engine in the same process keeps
// its own.
#pragma once

#include <string>

#include "gpu/vulkan.h"

namespace dermis::gpu {

inline constexpr const char* loader_library = "libvulkan.so.1";

/// Opens the Vulkan loader; returns null if it is not installed. It stays open for the life of the process,
/// because drivers do not survive unloading.
PFN_vkGetInstanceProcAddr open_loader(const std::string& library = loader_library);

/// Functions of an instance and its physical devices. The debug functions are null if VK_EXT_debug_utils is
/// not enabled.
struct InstanceTable {
  PFN_vkDestroyInstance destroy_instance;
  PFN_vkEnumeratePhysicalDevices enumerate_physical_devices;
  PFN_vkEnumerateDeviceExtensionProperties enumerate_device_extensions;
  PFN_vkGetPhysicalDeviceProperties get_properties;
  PFN_vkGetPhysicalDeviceProperties2 get_properties2;
  PFN_vkGetPhysicalDeviceFeatures2 get_features2;
  PFN_vkGetPhysicalDeviceMemoryProperties get_memory_properties;
  PFN_vkGetPhysicalDeviceQueueFamilyProperties get_queue_families;
  PFN_vkGetPhysicalDeviceFormatProperties2 get_format_properties2;
  PFN_vkGetPhysicalDeviceImageFormatProperties get_image_format_properties;
  PFN_vkCreateDevice create_device;
  PFN_vkGetDeviceProcAddr get_device_proc_addr;
  PFN_vkCreateDebugUtilsMessengerEXT create_messenger;
  PFN_vkDestroyDebugUtilsMessengerEXT destroy_messenger;
  PFN_vkSetDebugUtilsObjectNameEXT set_object_name;
  PFN_vkCmdBeginDebugUtilsLabelEXT begin_label;
  PFN_vkCmdEndDebugUtilsLabelEXT end_label;
};

InstanceTable load_instance_table(PFN_vkGetInstanceProcAddr get, VkInstance instance);
DeviceTable load_device_table(PFN_vkGetDeviceProcAddr get, VkDevice device);

}  // namespace dermis::gpu
