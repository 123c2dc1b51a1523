// SPDX-License-Identifier: MIT
#include "gpu/choose.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <sstream>

#include "base/core/error.h"
#include "base/core/known_names.h"

namespace dermis::gpu {
namespace {

template <class Features>
struct Need {
  VkBool32 Features::*member;
  const char* name;
};

// The only list of features, for RequiredFeatures and for the check of a device. Comments name the use where
// it is not obvious.
using F10 = VkPhysicalDeviceFeatures;
constexpr Need<F10> needs10[] = {
    {&F10::shaderClipDistance, "shaderClipDistance"},
    {&F10::depthClamp, "depthClamp"},                              // GraphicsDesc::depth_clamp
    {&F10::fragmentStoresAndAtomics, "fragmentStoresAndAtomics"},  // counters
    {&F10::shaderStorageImageExtendedFormats, "shaderStorageImageExtendedFormats"},
};
using F12 = VkPhysicalDeviceVulkan12Features;
constexpr Need<F12> needs12[] = {
    {&F12::scalarBlockLayout, "scalarBlockLayout"},
    {&F12::timelineSemaphore, "timelineSemaphore"},
    {&F12::separateDepthStencilLayouts, "separateDepthStencilLayouts"},  // DEPTH_ATTACHMENT_OPTIMAL
};
using F13 = VkPhysicalDeviceVulkan13Features;
constexpr Need<F13> needs13[] = {
    {&F13::dynamicRendering, "dynamicRendering"},
    {&F13::synchronization2, "synchronization2"},
    // For workgroup sizes by specialisation constant.
    {&F13::maintenance4, "maintenance4"},
    // `discard` may compile to these two.
    {&F13::shaderDemoteToHelperInvocation, "shaderDemoteToHelperInvocation"},
    {&F13::shaderTerminateInvocation, "shaderTerminateInvocation"},
};

constexpr const char* extension_names[] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};

constexpr FormatNeed needed_formats[] = {
    {VK_FORMAT_R16G16B16A16_SFLOAT,
     VK_FORMAT_FEATURE_2_COLOR_ATTACHMENT_BLEND_BIT | VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT |
         VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_FILTER_LINEAR_BIT,
     "half-float images that are drawn to, blended, stored to and filtered"},
    {VK_FORMAT_D32_SFLOAT,
     // Filtering is not required: the software driver does not claim it for depth, and Vulkan requires it
     // only without comparison.
     VK_FORMAT_FEATURE_2_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_BIT |
         VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_DEPTH_COMPARISON_BIT,
     "32-bit depth images that are drawn to and sampled with a comparison"},
};

template <class Features, std::size_t N>
void require(Features& features, const Need<Features> (&needs)[N]) {
  for (const auto& need : needs) features.*need.member = VK_TRUE;
}

template <class Features, std::size_t N>
void compare(const Features& features, const Need<Features> (&needs)[N], std::vector<std::string>& missing) {
  for (const auto& need : needs)
    if (!(features.*need.member))
      missing.push_back(
          fmt::format("needs the Vulkan feature {}, which this driver does not have", need.name));
}

std::string version_text(std::uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

const char* type_text(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return "software";
    default: return "other";
  }
}

int rank_of(const Candidate& candidate) {
  constexpr std::array order{VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU,
                             VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU, VK_PHYSICAL_DEVICE_TYPE_CPU};
  const int place = static_cast<int>(std::ranges::find(order, candidate.type) - order.begin());
  return place + (candidate.summary.missing.empty() ? 0 : 100);
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string names_of(std::span<const Candidate> candidates) {
  std::string list;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    list += fmt::format("{}{}: {}", i ? "; " : "", i, candidates[i].summary.name);
  return list;
}

// A part of a name is enough to choose a device.
std::vector<std::string> words_of(std::span<const Candidate> candidates) {
  std::vector<std::string> words{"best"};
  for (const Candidate& candidate : candidates) {
    std::istringstream name(candidate.summary.name);
    for (std::string word; name >> word;) words.push_back(word);
  }
  return words;
}

const Candidate& usable(const Candidate& candidate) {
  const DeviceInfo& summary = candidate.summary;
  if (!summary.missing.empty())
    throw device_error("{} cannot be used: {}", summary.name, fmt::join(summary.missing, "; "));
  return candidate;
}

void find_features(const InstanceTable& table, VkPhysicalDevice device, DeviceFacts& facts,
                   bool& anisotropy) {
  VkPhysicalDeviceFeatures2 features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  facts.features11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
  facts.features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  facts.features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  features.pNext = &facts.features11;
  facts.features11.pNext = &facts.features12;
  facts.features12.pNext = &facts.features13;
  table.get_features2(device, &features);
  facts.features = features.features;
  anisotropy = features.features.samplerAnisotropy == VK_TRUE;
}

void find_extensions(const InstanceTable& table, VkPhysicalDevice device, DeviceFacts& facts) {
  std::uint32_t count = 0;
  if (table.enumerate_device_extensions(device, nullptr, &count, nullptr) != VK_SUCCESS) return;
  std::vector<VkExtensionProperties> extensions(count);
  if (table.enumerate_device_extensions(device, nullptr, &count, extensions.data()) != VK_SUCCESS) return;
  for (const VkExtensionProperties& extension : extensions)
    facts.extensions.emplace_back(extension.extensionName);
}

void find_formats(const InstanceTable& table, VkPhysicalDevice device, DeviceFacts& facts) {
  for (const FormatNeed& need : format_needs()) {
    VkFormatProperties3 properties3{};
    properties3.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3;
    VkFormatProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2;
    properties.pNext = &properties3;
    table.get_format_properties2(device, need.format, &properties);
    facts.formats.push_back(properties3.optimalTilingFeatures);
  }
}

void find_queue(const InstanceTable& table, std::optional<std::uint32_t> wanted, Candidate& candidate,
                DeviceFacts& facts) {
  std::uint32_t count = 0;
  table.get_queue_families(candidate.handle, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  table.get_queue_families(candidate.handle, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i) {
    constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    if ((wanted && *wanted != i) || (families[i].queueFlags & both) != both) continue;
    facts.graphics_and_compute_queue = true;
    candidate.queue_family = i;
    candidate.timestamp_bits = families[i].timestampValidBits;
    return;
  }
}

std::uint64_t device_memory_bytes(const InstanceTable& table, VkPhysicalDevice device) {
  VkPhysicalDeviceMemoryProperties memory{};
  table.get_memory_properties(device, &memory);
  std::uint64_t largest = 0;
  for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
    if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      largest = std::max(largest, memory.memoryHeaps[i].size);
  return largest;
}

}  // namespace

std::span<const FormatNeed> format_needs() { return needed_formats; }

std::vector<std::string> missing_of(const DeviceFacts& facts) {
  std::vector<std::string> missing;
  const bool api = facts.api_version >= RequiredFeatures::api_version;
  if (!api)
    missing.push_back(
        fmt::format("needs Vulkan 1.3, has {}: update the driver", version_text(facts.api_version)));

  compare(facts.features, needs10, missing);
  if (api) {  // an older driver leaves these structures empty; a message for each would hide the reason
    compare(facts.features12, needs12, missing);
    compare(facts.features13, needs13, missing);
  }

  for (const char* name : extension_names)
    if (std::ranges::find(facts.extensions, name) == facts.extensions.end())
      missing.push_back(fmt::format("needs the Vulkan extension {}, which this driver does not have", name));
  if (!facts.graphics_and_compute_queue)
    missing.emplace_back("needs a queue that does both graphics and compute");

  for (std::size_t i = 0; api && i < std::size(needed_formats); ++i)
    if (i >= facts.formats.size() ||
        (facts.formats[i] & needed_formats[i].features) != needed_formats[i].features)
      missing.push_back(fmt::format("needs {}", needed_formats[i].purpose));
  if (!(facts.colour_samples & facts.depth_samples & VK_SAMPLE_COUNT_4_BIT))
    missing.emplace_back("needs colour and depth images with 4 samples");

  return missing;
}

Candidate examine(const InstanceTable& table, VkPhysicalDevice device, std::optional<std::uint32_t> family) {
  Candidate candidate;
  candidate.handle = device;
  DeviceFacts facts;

  VkPhysicalDeviceProperties plain{};
  table.get_properties(device, &plain);
  facts.api_version = plain.apiVersion;
  facts.colour_samples = plain.limits.framebufferColorSampleCounts;
  facts.depth_samples = plain.limits.framebufferDepthSampleCounts;
  candidate.type = plain.deviceType;

  DeviceInfo& summary = candidate.summary;
  summary.name = plain.deviceName;
  summary.type = type_text(plain.deviceType);
  summary.api = version_text(plain.apiVersion);
  summary.memory_bytes = device_memory_bytes(table, device);

  find_queue(table, family, candidate, facts);
  find_extensions(table, device, facts);
  if (plain.apiVersion >= VK_API_VERSION_1_2) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    table.get_properties2(device, &properties);
    summary.driver = fmt::format("{} {}", driver.driverName, driver.driverInfo);
    find_features(table, device, facts, candidate.anisotropy);
    find_formats(table, device, facts);
  }

  summary.missing = missing_of(facts);
  return candidate;
}

void sort_best_first(std::vector<Candidate>& candidates) {
  std::ranges::stable_sort(candidates, {}, rank_of);
}

std::string no_driver_message() {
  return "no Vulkan driver found, a Vulkan 1.3 device is needed: install the GPU's driver, or the software "
         "driver (Debian, Ubuntu: apt "
         "install "
         "mesa-vulkan-drivers)";
}

const Candidate& choose(std::span<const Candidate> sorted, const std::string& select) {
  if (sorted.empty()) throw device_error("{}", no_driver_message());
  if (select.empty() || select == "best") return usable(sorted.front());
  std::size_t index = 0;
  const char* end = select.data() + select.size();
  const auto [stop, error] = std::from_chars(select.data(), end, index);
  if (stop == end && error == std::errc{} && index < sorted.size()) return usable(sorted[index]);
  for (const Candidate& candidate : sorted)
    if (lower(candidate.summary.name).find(lower(select)) != std::string::npos) return usable(candidate);
  throw device_error("no device '{}'; there are: {}{}", select, names_of(sorted),
                     did_you_mean(select, words_of(sorted)));
}

}  // namespace dermis::gpu

// Part of the public header, so not of this namespace.
dermis::vulkan::RequiredFeatures::RequiredFeatures() {
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  features11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
  features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  features13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  features.pNext = &features11;
  features11.pNext = &features12;
  features12.pNext = &features13;
  dermis::gpu::require(features.features, dermis::gpu::needs10);
  dermis::gpu::require(features12, dermis::gpu::needs12);
  dermis::gpu::require(features13, dermis::gpu::needs13);
}

std::span<const char* const> dermis::vulkan::RequiredFeatures::extensions() {
  return dermis::gpu::extension_names;
}
