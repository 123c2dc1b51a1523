// SPDX-License-Identifier: MIT
#include "gpu/loader.h"

#include <dlfcn.h>

namespace dermis::gpu {
PFN_vkGetInstanceProcAddr open_loader(const std::string& library) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return nullptr;
  return reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(handle, "vkGetInstanceProcAddr"));
}

InstanceTable load_instance_table(PFN_vkGetInstanceProcAddr get, VkInstance instance) {
  InstanceTable t{};
  const auto load = [&]<class F>(F& function, const char* name) {
    function = reinterpret_cast<F>(get(instance, name));
  };

  load(t.destroy_instance, "vkDestroyInstance");
  load(t.enumerate_physical_devices, "vkEnumeratePhysicalDevices");
  load(t.enumerate_device_extensions, "vkEnumerateDeviceExtensionProperties");
  load(t.get_properties, "vkGetPhysicalDeviceProperties");
  load(t.get_properties2, "vkGetPhysicalDeviceProperties2");
  load(t.get_features2, "vkGetPhysicalDeviceFeatures2");
  load(t.get_memory_properties, "vkGetPhysicalDeviceMemoryProperties");
  load(t.get_queue_families, "vkGetPhysicalDeviceQueueFamilyProperties");
  load(t.get_format_properties2, "vkGetPhysicalDeviceFormatProperties2");
  load(t.get_image_format_properties, "vkGetPhysicalDeviceImageFormatProperties");

  load(t.create_device, "vkCreateDevice");
  load(t.get_device_proc_addr, "vkGetDeviceProcAddr");

  load(t.create_messenger, "vkCreateDebugUtilsMessengerEXT");
  load(t.destroy_messenger, "vkDestroyDebugUtilsMessengerEXT");
  load(t.set_object_name, "vkSetDebugUtilsObjectNameEXT");
  load(t.begin_label, "vkCmdBeginDebugUtilsLabelEXT");
  load(t.end_label, "vkCmdEndDebugUtilsLabelEXT");

  return t;
}

DeviceTable load_device_table(PFN_vkGetDeviceProcAddr get, VkDevice device) {
  DeviceTable table;
#define DERMIS_LOAD(name) table.name = reinterpret_cast<PFN_##name>(get(device, #name));
  DERMIS_DEVICE_FUNCTIONS(DERMIS_LOAD)
#undef DERMIS_LOAD
  return table;
}

}  // namespace dermis::gpu
