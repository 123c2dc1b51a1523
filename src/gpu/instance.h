// SPDX-License-Identifier: MIT
// Our own VkInstance, with the validation layer on request. Not used with an engine's device.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gpu/loader.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

class Instance {
 public:
  /// Throws DeviceError (one line that says what to install): no loader, no driver, no validation layer.
  explicit Instance(bool validate, const std::string& library = loader_library);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  ~Instance();

  VkInstance handle() const { return handle_; }
  const InstanceTable& table() const { return table_; }
  std::vector<VkPhysicalDevice> physical_devices() const;
  const std::vector<std::string>& messages() const;

 private:
  /// Written by the layer's callback, from any thread.
  struct Log {
    std::mutex mutex;
    std::vector<std::string> messages;
  };
  static VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                   VkDebugUtilsMessageTypeFlagsEXT type,
                                                   const VkDebugUtilsMessengerCallbackDataEXT* data,
                                                   void* log);
  VkDebugUtilsMessengerCreateInfoEXT messenger_info() const;
  void create(PFN_vkGetInstanceProcAddr get, bool validate);

  std::unique_ptr<Log> log_ = std::make_unique<Log>();
  VkInstance handle_ = VK_NULL_HANDLE;
  InstanceTable table_{};
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
};

}  // namespace dermis::gpu
