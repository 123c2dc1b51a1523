// SPDX-License-Identifier: MIT
#include "gpu/instance.h"

#include <algorithm>
#include <string_view>

#include "base/core/error.h"
#include "gpu/choose.h"
#include "gpu/device.h"

namespace dermis::gpu {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

template <class F>
F global_function(PFN_vkGetInstanceProcAddr get, const char* name) {
  return reinterpret_cast<F>(get(VK_NULL_HANDLE, name));
}

bool has_layer(PFN_vkGetInstanceProcAddr get, std::string_view name) {
  const auto enumerate =
      global_function<PFN_vkEnumerateInstanceLayerProperties>(get, "vkEnumerateInstanceLayerProperties");
  std::uint32_t count = 0;
  check(enumerate(&count, nullptr), "vkEnumerateInstanceLayerProperties");
  std::vector<VkLayerProperties> layers(count);
  check(enumerate(&count, layers.data()), "vkEnumerateInstanceLayerProperties");
  return std::ranges::any_of(layers, [&](const VkLayerProperties& layer) { return layer.layerName == name; });
}

bool has_extension(PFN_vkGetInstanceProcAddr get, const char* layer, std::string_view name) {
  const auto enumerate = global_function<PFN_vkEnumerateInstanceExtensionProperties>(
      get, "vkEnumerateInstanceExtensionProperties");
  std::uint32_t count = 0;
  if (enumerate(layer, &count, nullptr) != VK_SUCCESS) return false;
  std::vector<VkExtensionProperties> extensions(count);
  if (enumerate(layer, &count, extensions.data()) != VK_SUCCESS) return false;
  return std::ranges::any_of(extensions,
                             [&](const VkExtensionProperties& e) { return e.extensionName == name; });
}

}  // namespace

VkBool32 Instance::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                              VkDebugUtilsMessageTypeFlagsEXT type,
                              const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
  const std::string_view id = data->pMessageIdName ? data->pMessageIdName : "";
  // The loader reports here drivers that it could not open, which is not our fault. Nor is it ours that
  // NVIDIA's driver asks for functions of the instance by vkGetDeviceProcAddr when a device is made.
  if (id == "Loader Message" || id == "WARNING-vkGetDeviceProcAddr-device") return VK_FALSE;
  const bool error = (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0;
  if (!error && (type & VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT) == 0) return VK_FALSE;
  // Layers of today leave their name for the fault out of the text.
  const std::string_view said = data->pMessage ? data->pMessage : "";
  std::string text = error ? "error: " : "warning: ";
  if (!id.empty() && said.find(id) == std::string_view::npos) text += fmt::format("[ {} ] ", id);
  text += said;
  std::ranges::replace(text, '\n', ' ');
  auto& target = *static_cast<Log*>(log);
  const std::lock_guard lock(target.mutex);
  target.messages.push_back(std::move(text));
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT Instance::messenger_info() const {
  VkDebugUtilsMessengerCreateInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = on_message;
  info.pUserData = log_.get();
  return info;
}

void Instance::create(PFN_vkGetInstanceProcAddr get, bool validate) {
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.pApplicationName = "dermis";
  application.apiVersion = RequiredFeatures::api_version;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;

  std::vector<const char*> extensions;
  if (validate || has_extension(get, nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME))
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info();
  const VkValidationFeatureEnableEXT synchronization =
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{};
  features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &synchronization;
  features.pNext = &messenger;
  if (validate) {
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &validation_layer;
    info.pNext = &features;
  }
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();

  const VkResult result =
      global_function<PFN_vkCreateInstance>(get, "vkCreateInstance")(&info, nullptr, &handle_);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throw device_error("{}", no_driver_message());
  check(result, "vkCreateInstance");
}

Instance::Instance(bool validate, const std::string& library) {
  const PFN_vkGetInstanceProcAddr get = open_loader(library);
  if (get == nullptr) {
    throw device_error(
        "no Vulkan loader ({}): install it and a driver (Debian, Ubuntu: apt install libvulkan1 "
        "mesa-vulkan-drivers)",
        library);
  }

  if (validate && (!has_layer(get, validation_layer) ||
                   !has_extension(get, validation_layer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME)))
    throw device_error(
        "validation needs the layer {}, which is not installed (Debian, Ubuntu: apt install "
        "vulkan-validationlayers)",
        validation_layer);

  create(get, validate);
  table_ = load_instance_table(get, handle_);
  if (!validate) return;

  const VkDebugUtilsMessengerCreateInfoEXT info = messenger_info();
  const VkResult result = table_.create_messenger(handle_, &info, nullptr, &messenger_);
  if (result == VK_SUCCESS) return;

  // The destructor does not run after a constructor that throws.
  table_.destroy_instance(handle_, nullptr);
  check(result, "vkCreateDebugUtilsMessengerEXT");
}

Instance::~Instance() {
  if (messenger_) table_.destroy_messenger(handle_, messenger_, nullptr);
  table_.destroy_instance(handle_, nullptr);
}

std::vector<VkPhysicalDevice> Instance::physical_devices() const {
  std::uint32_t count = 0;
  if (table_.enumerate_physical_devices(handle_, &count, nullptr) != VK_SUCCESS) return {};
  std::vector<VkPhysicalDevice> devices(count);
  if (table_.enumerate_physical_devices(handle_, &count, devices.data()) != VK_SUCCESS) return {};
  devices.resize(count);
  return devices;
}

const std::vector<std::string>& Instance::messages() const { return log_->messages; }

}  // namespace dermis::gpu
