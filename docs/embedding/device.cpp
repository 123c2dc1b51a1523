// SPDX-License-Identifier: MIT
#include "device.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>

namespace host {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

VKAPI_ATTR VkBool32 VKAPI_CALL keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                            VkDebugUtilsMessageTypeFlagsEXT,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data,
                                            void* messages) {
  // At once: some are said while the device is destroyed.
  std::fprintf(stderr, "validation: %s\n", data->pMessage);
  static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info(std::vector<std::string>& messages) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = keep_message;
  info.pUserData = &messages;
  return info;
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

std::optional<std::uint32_t> family_of(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (std::uint32_t i = 0; i < count; ++i)
    if ((families[i].queueFlags & needed) == needed) return i;
  return {};
}

VkImageAspectFlags aspect_of(VkFormat format) {
  switch (format) {
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D32_SFLOAT: return VK_IMAGE_ASPECT_DEPTH_BIT;
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT: return VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    default: return VK_IMAGE_ASPECT_COLOR_BIT;
  }
}

Owned<VkCommandPool> make_pool(const Device& device) {
  VkCommandPoolCreateInfo info{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  info.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  info.queueFamilyIndex = device.queue_family();
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device.handle(), &info, nullptr, &pool), "vkCreateCommandPool");
  return {device.handle(), pool, vkDestroyCommandPool};
}

VkCommandBuffer make_commands(VkDevice device, VkCommandPool pool) {
  VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  info.commandPool = pool;
  info.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(device, &info, &commands), "vkAllocateCommandBuffers");
  return commands;
}

void begin_commands(VkCommandBuffer commands) {
  VkCommandBufferBeginInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
}

}  // namespace

void check(VkResult result, const char* call) {
  if (result != VK_SUCCESS)
    throw std::runtime_error(std::string(call) + " failed with VkResult " + std::to_string(result));
}

Device::Device(bool validate) {
  make_instance(validate);
  make_device();
  pool_ = make_pool(*this);
}

Device::Handles::~Handles() {
  if (device) {
    vkDeviceWaitIdle(device);
    vkDestroyDevice(device, nullptr);
  }
  if (messenger) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance, messenger, nullptr);
  }
  if (instance) vkDestroyInstance(instance, nullptr);
}

void Device::make_instance(bool validate) {
  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = dermis::vulkan::RequiredFeatures::api_version;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  if (!validate || !has_validation_layer()) {
    check(vkCreateInstance(&info, nullptr, &vk_.instance), "vkCreateInstance");
    return;
  }

  const VkValidationFeatureEnableEXT enabled = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &enabled;
  // Chained to the instance, it also hears what is said while that is made and destroyed.
  const VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(messages_);
  features.pNext = &messenger;
  constexpr std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                                  VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
  info.pNext = &features;
  info.enabledLayerCount = 1;
  info.ppEnabledLayerNames = &validation_layer;
  info.enabledExtensionCount = extensions.size();
  info.ppEnabledExtensionNames = extensions.data();
  check(vkCreateInstance(&info, nullptr, &vk_.instance), "vkCreateInstance");

  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(vk_.instance, "vkCreateDebugUtilsMessengerEXT"));
  check(create(vk_.instance, &messenger, nullptr, &vk_.messenger), "vkCreateDebugUtilsMessengerEXT");
}

void Device::make_device() {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(vk_.instance, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(vk_.instance, &count, devices.data()), "vkEnumeratePhysicalDevices");
  std::stable_sort(devices.begin(), devices.end(),
                   [](VkPhysicalDevice a, VkPhysicalDevice b) { return rank_of(a) < rank_of(b); });

  for (const VkPhysicalDevice physical : devices)
    if (try_device(physical) == VK_SUCCESS) return;
  throw std::runtime_error("no Vulkan device has what dermis needs, of " + std::to_string(count));
}

VkResult Device::try_device(VkPhysicalDevice physical) {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical, &properties);
  const std::optional<std::uint32_t> family = family_of(physical);
  if (properties.apiVersion < dermis::vulkan::RequiredFeatures::api_version || !family)
    return VK_ERROR_FEATURE_NOT_PRESENT;

  // What dermis needs, and what this host needs: it adds to the same structures.
  dermis::vulkan::RequiredFeatures required;
  VkPhysicalDeviceFeatures can{};
  vkGetPhysicalDeviceFeatures(physical, &can);
  required.features.features.samplerAnisotropy = can.samplerAnisotropy;
  required.features12.timelineSemaphore = VK_TRUE;
  required.features13.dynamicRendering = VK_TRUE;
  required.features13.synchronization2 = VK_TRUE;

  constexpr float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = *family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const std::span<const char* const> extensions = dermis::vulkan::RequiredFeatures::extensions();
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &required.features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  const VkResult result = vkCreateDevice(physical, &info, nullptr, &vk_.device);
  if (result != VK_SUCCESS) return result;

  physical_ = physical;
  queue_family_ = *family;
  sampler_anisotropy_ = can.samplerAnisotropy == VK_TRUE;
  vkGetDeviceQueue(vk_.device, queue_family_, 0, &queue_);
  vkGetPhysicalDeviceMemoryProperties(physical, &memory_);
  return VK_SUCCESS;
}

std::string Device::name() const {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical_, &properties);
  return properties.deviceName;
}

dermis::vulkan::Host Device::host() const {
  return {.get_instance_proc_addr = vkGetInstanceProcAddr,
          .instance = vk_.instance,
          .physical_device = physical_,
          .device = vk_.device,
          .queue = queue_,
          .queue_family = queue_family_,
          .sampler_anisotropy = sampler_anisotropy_};
}

Owned<VkDeviceMemory> Device::allocate(const VkMemoryRequirements& needs,
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

Image Device::make_image(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                         std::uint32_t samples) const {
  Image made;
  made.format = format;
  made.extent = extent;
  made.aspect = aspect_of(format);

  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = static_cast<VkSampleCountFlagBits>(samples);
  info.usage = usage;
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
  view_info.format = format;
  view_info.subresourceRange = {made.aspect & ~VkImageAspectFlags{VK_IMAGE_ASPECT_STENCIL_BIT}, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(vk_.device, &view_info, nullptr, &view), "vkCreateImageView");
  made.view = {vk_.device, view, vkDestroyImageView};
  return made;
}

Buffer Device::make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) const {
  Buffer made;
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

void Device::run(const std::function<void(VkCommandBuffer)>& record) const {
  check(vkResetCommandPool(vk_.device, pool_.get(), VK_COMMAND_POOL_RESET_RELEASE_RESOURCES_BIT),
        "vkResetCommandPool");
  const VkCommandBuffer commands = make_commands(vk_.device, pool_.get());
  begin_commands(commands);
  record(commands);
  check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");

  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands;
  check(vkQueueSubmit(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
  check(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
  vkFreeCommandBuffers(vk_.device, pool_.get(), 1, &commands);
}

std::vector<std::byte> Device::read(Image& image, std::size_t bytes_per_texel) const {
  const Buffer copy = make_buffer(bytes_per_texel * image.extent.width * image.extent.height,
                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  run([&](VkCommandBuffer commands) {
    transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy region{};
    region.imageSubresource = {image.aspect & ~VkImageAspectFlags{VK_IMAGE_ASPECT_STENCIL_BIT}, 0, 0, 1};
    region.imageExtent = {image.extent.width, image.extent.height, 1};
    vkCmdCopyImageToBuffer(commands, image.image.get(), image.layout, copy.buffer.get(), 1, &region);
    // What the device has written, the processor may read.
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
  });
  return {copy.mapped, copy.mapped + copy.bytes};
}

Frames::Frames(const Device& device, std::uint32_t in_flight) : device_(&device) {
  VkSemaphoreTypeCreateInfo timeline{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO};
  timeline.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  info.pNext = &timeline;
  VkSemaphore finished = VK_NULL_HANDLE;
  check(vkCreateSemaphore(device.handle(), &info, nullptr, &finished), "vkCreateSemaphore");
  finished_ = {device.handle(), finished, vkDestroySemaphore};

  for (std::uint32_t i = 0; i < in_flight; ++i) {
    Slot slot{.pool = make_pool(device)};
    slot.commands = make_commands(device.handle(), slot.pool.get());
    slots_.push_back(std::move(slot));
  }
}

Frames::~Frames() { vkQueueWaitIdle(device_->queue()); }

void Frames::wait_for(std::uint64_t frame) const {
  const VkSemaphore semaphore = finished_.get();
  VkSemaphoreWaitInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO};
  info.semaphoreCount = 1;
  info.pSemaphores = &semaphore;
  info.pValues = &frame;
  check(vkWaitSemaphores(device_->handle(), &info, std::numeric_limits<std::uint64_t>::max()),
        "vkWaitSemaphores");
}

Frames::Frame Frames::begin() {
  ++number_;
  const std::uint64_t in_flight = slots_.size();
  if (number_ > in_flight) wait_for(number_ - in_flight);
  Frame frame{.numbers = {.frame = number_}, .slot = static_cast<std::uint32_t>(number_ % in_flight)};
  check(vkGetSemaphoreCounterValue(device_->handle(), finished_.get(), &frame.numbers.finished),
        "vkGetSemaphoreCounterValue");

  const Slot& slot = slots_[frame.slot];
  check(vkResetCommandPool(device_->handle(), slot.pool.get(), 0), "vkResetCommandPool");
  begin_commands(slot.commands);
  frame.commands = slot.commands;
  return frame;
}

void Frames::submit() {
  const Slot& slot = slots_[number_ % slots_.size()];
  check(vkEndCommandBuffer(slot.commands), "vkEndCommandBuffer");
  VkCommandBufferSubmitInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  commands.commandBuffer = slot.commands;
  VkSemaphoreSubmitInfo signal{VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO};
  signal.semaphore = finished_.get();
  signal.value = number_;
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &commands;
  submit.signalSemaphoreInfoCount = 1;
  submit.pSignalSemaphoreInfos = &signal;
  check(vkQueueSubmit2(device_->queue(), 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2");
}

void transition(VkCommandBuffer commands, Image& image, VkImageLayout layout) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = image.layout;
  barrier.newLayout = image.layout = layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.image.get();
  barrier.subresourceRange = {image.aspect, 0, 1, 0, 1};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  vkCmdPipelineBarrier2(commands, &dependency);
}

void begin_rendering(VkCommandBuffer commands, const Image* colour, const Image* depth,
                     const std::optional<std::array<float, 4>>& clear_colour,
                     const std::optional<float>& clear_depth) {
  VkRenderingAttachmentInfo colour_info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO},
      depth_info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  const VkExtent2D extent = (colour ? colour : depth)->extent;
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = {{0, 0}, extent};
  info.layerCount = 1;

  if (colour) {
    colour_info.imageView = colour->view.get();
    colour_info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    colour_info.loadOp = clear_colour ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    colour_info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    const std::array<float, 4> c = clear_colour.value_or(std::array<float, 4>{});
    colour_info.clearValue.color = {{c[0], c[1], c[2], c[3]}};
    info.colorAttachmentCount = 1;
    info.pColorAttachments = &colour_info;
  }
  if (depth) {
    depth_info.imageView = depth->view.get();
    depth_info.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
    depth_info.loadOp = clear_depth ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    depth_info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    depth_info.clearValue.depthStencil = {clear_depth.value_or(0), 0};
    info.pDepthAttachment = &depth_info;
  }
  vkCmdBeginRendering(commands, &info);

  const VkViewport viewport{0, 0, static_cast<float>(extent.width), static_cast<float>(extent.height), 0, 1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &info.renderArea);
}

}  // namespace host
