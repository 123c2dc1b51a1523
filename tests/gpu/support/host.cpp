// SPDX-License-Identifier: MIT
#include "gpu/support/host.h"

#include <gtest/gtest.h>

#include "gpu/formats.h"
#include "gpu/resources.h"

namespace dermis::tests {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                            VkDebugUtilsMessageTypeFlagsEXT type,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data,
                                            void* messages) {
  if (type & VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT)
    static_cast<std::vector<std::string>*>(messages)->emplace_back(data->pMessage);
  return VK_FALSE;
}

void expect_success(VkResult result) { ASSERT_EQ(result, VK_SUCCESS); }

}  // namespace

template <class F>
void Host::load(F& function, const char* name) const {
  function = reinterpret_cast<F>(get_(instance_, name));
}

Host::Host() : get_(gpu::open_loader()) {
  make_instance();
  make_device();
}

void Host::make_instance() {
  PFN_vkCreateInstance create{};
  load(create, "vkCreateInstance");
  VkDebugUtilsMessengerCreateInfoEXT messenger{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messenger.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  messenger.pfnUserCallback = keep_message;
  messenger.pUserData = &messages_;
  const VkValidationFeatureEnableEXT synchronization =
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = &synchronization;

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = vulkan::RequiredFeatures::api_version;
  const char* layer = "VK_LAYER_KHRONOS_validation";
  const std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pNext = &features;
  info.pApplicationInfo = &application;
  info.enabledLayerCount = 1;
  info.ppEnabledLayerNames = &layer;
  info.enabledExtensionCount = extensions.size();
  info.ppEnabledExtensionNames = extensions.data();

  // Works without the layer too, with less to see.
  if (create(&info, nullptr, &instance_) == VK_SUCCESS) {
    PFN_vkCreateDebugUtilsMessengerEXT create_messenger{};
    load(create_messenger, "vkCreateDebugUtilsMessengerEXT");
    expect_success(create_messenger(instance_, &messenger, nullptr, &messenger_));
    return;
  }
  info.pNext = nullptr;
  info.enabledLayerCount = info.enabledExtensionCount = 0;
  expect_success(create(&info, nullptr, &instance_));
}

void Host::make_device() {
  PFN_vkEnumeratePhysicalDevices enumerate{};
  load(enumerate, "vkEnumeratePhysicalDevices");
  std::uint32_t one = 1;
  enumerate(instance_, &one, &physical_);
  PFN_vkGetPhysicalDeviceMemoryProperties memory{};
  load(memory, "vkGetPhysicalDeviceMemoryProperties");
  memory(physical_, &memory_);

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  // As the renderer's own device has it, so that both read maps alike.
  PFN_vkGetPhysicalDeviceFeatures features{};
  load(features, "vkGetPhysicalDeviceFeatures");
  VkPhysicalDeviceFeatures can{};
  features(physical_, &can);
  vulkan::RequiredFeatures required;
  required.features.features.samplerAnisotropy = can.samplerAnisotropy;
  sampler_anisotropy_ = can.samplerAnisotropy == VK_TRUE;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &required.features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(vulkan::RequiredFeatures::extensions().size());
  info.ppEnabledExtensionNames = vulkan::RequiredFeatures::extensions().data();
  PFN_vkCreateDevice create{};
  load(create, "vkCreateDevice");
  expect_success(create(physical_, &info, nullptr, &device_));

  PFN_vkGetDeviceProcAddr get_device{};
  load(get_device, "vkGetDeviceProcAddr");
  vk_ = gpu::load_device_table(get_device, device_);
  vk_.vkGetDeviceQueue(device_, 0, 0, &queue_);
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  expect_success(vk_.vkCreateCommandPool(device_, &pool, nullptr, &pool_));
}

Host::~Host() {
  vk_.vkDeviceWaitIdle(device_);
  for (const HostImage& image : images_) {
    vk_.vkDestroyImageView(device_, image.view, nullptr);
    vk_.vkDestroyImage(device_, image.handle, nullptr);
    vk_.vkFreeMemory(device_, image.memory, nullptr);
  }
  for (const HostBuffer& buffer : buffers_) {
    vk_.vkDestroyBuffer(device_, buffer.handle, nullptr);
    vk_.vkFreeMemory(device_, buffer.memory, nullptr);
  }
  vk_.vkDestroyCommandPool(device_, pool_, nullptr);
  vk_.vkDestroyDevice(device_, nullptr);

  PFN_vkDestroyDebugUtilsMessengerEXT destroy_messenger{};
  load(destroy_messenger, "vkDestroyDebugUtilsMessengerEXT");
  if (messenger_) destroy_messenger(instance_, messenger_, nullptr);
  PFN_vkDestroyInstance destroy{};
  load(destroy, "vkDestroyInstance");
  destroy(instance_, nullptr);
}

vulkan::Host Host::vulkan() const {
  return {.get_instance_proc_addr = get_,
          .instance = instance_,
          .physical_device = physical_,
          .device = device_,
          .queue = queue_,
          .sampler_anisotropy = sampler_anisotropy_};
}

VkDeviceMemory Host::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties) {
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = needs.size;
  while (!(needs.memoryTypeBits >> info.memoryTypeIndex & 1u) ||
         (memory_.memoryTypes[info.memoryTypeIndex].propertyFlags & properties) != properties)
    ++info.memoryTypeIndex;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  expect_success(vk_.vkAllocateMemory(device_, &info, nullptr, &memory));
  return memory;
}

HostImage Host::image(VkFormat format, VkExtent2D extent, std::uint32_t samples, VkImageUsageFlags usage) {
  HostImage image{.format = format, .extent = extent};
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = static_cast<VkSampleCountFlagBits>(samples);
  info.usage = usage | (samples == 1 ? VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT : 0);
  expect_success(vk_.vkCreateImage(device_, &info, nullptr, &image.handle));

  VkImageMemoryRequirementsInfo2 of{VK_STRUCTURE_TYPE_IMAGE_MEMORY_REQUIREMENTS_INFO_2, nullptr,
                                    image.handle};
  VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vk_.vkGetImageMemoryRequirements2(device_, &of, &needs);
  image.memory = allocate(needs.memoryRequirements, 0);
  expect_success(vk_.vkBindImageMemory(device_, image.handle, image.memory, 0));

  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image.handle;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = format;
  view.subresourceRange = {gpu::aspect_of(format), 0, 1, 0, 1};
  expect_success(vk_.vkCreateImageView(device_, &view, nullptr, &image.view));
  images_.push_back(image);
  return image;
}

HostBuffer Host::buffer(std::uint64_t bytes, VkBufferUsageFlags usage) {
  HostBuffer buffer{.bytes = bytes};
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = usage;
  expect_success(vk_.vkCreateBuffer(device_, &info, nullptr, &buffer.handle));
  VkBufferMemoryRequirementsInfo2 of{VK_STRUCTURE_TYPE_BUFFER_MEMORY_REQUIREMENTS_INFO_2, nullptr,
                                     buffer.handle};
  VkMemoryRequirements2 needs{VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
  vk_.vkGetBufferMemoryRequirements2(device_, &of, &needs);
  buffer.memory = allocate(needs.memoryRequirements,
                           VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  expect_success(vk_.vkBindBufferMemory(device_, buffer.handle, buffer.memory, 0));
  void* mapped = nullptr;
  expect_success(vk_.vkMapMemory(device_, buffer.memory, 0, VK_WHOLE_SIZE, 0, &mapped));
  buffer.mapped = static_cast<std::byte*>(mapped);
  buffers_.push_back(buffer);
  return buffer;
}

void Host::run(const std::function<void(VkCommandBuffer)>& record) {
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool_;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  expect_success(vk_.vkAllocateCommandBuffers(device_, &allocate, &commands));
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  expect_success(vk_.vkBeginCommandBuffer(commands, &begin));
  record(commands);
  expect_success(vk_.vkEndCommandBuffer(commands));
  VkSubmitInfo info{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  info.commandBufferCount = 1;
  info.pCommandBuffers = &commands;
  expect_success(vk_.vkQueueSubmit(queue_, 1, &info, VK_NULL_HANDLE));
  expect_success(vk_.vkDeviceWaitIdle(device_));
}

void Host::transition(VkCommandBuffer commands, HostImage& image, VkImageLayout layout) {
  VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  barrier.oldLayout = image.layout;
  barrier.newLayout = image.layout = layout;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.handle;
  barrier.subresourceRange = {gpu::aspect_of(image.format), 0, 1, 0, 1};
  VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &barrier;
  vk_.vkCmdPipelineBarrier2(commands, &info);
}

void Host::clear(VkCommandBuffer commands, const HostImage* colour, std::array<float, 4> value,
                 const HostImage* depth, float depth_value, VkRect2D area) {
  VkRenderingAttachmentInfo colour_info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO},
      depth_info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  colour_info.loadOp = depth_info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  colour_info.storeOp = depth_info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour_info.clearValue.color = {{value[0], value[1], value[2], value[3]}};
  depth_info.clearValue.depthStencil = {depth_value, 0};
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = area;
  info.layerCount = 1;
  if (colour) {
    colour_info.imageView = colour->view;
    colour_info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    info.colorAttachmentCount = 1;
    info.pColorAttachments = &colour_info;
  }
  if (depth) {
    depth_info.imageView = depth->view;
    depth_info.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
    info.pDepthAttachment = &depth_info;
  }
  vk_.vkCmdBeginRendering(commands, &info);
  vk_.vkCmdEndRendering(commands);
}

void Host::resolve(VkCommandBuffer commands, const HostImage& from, const HostImage& to) {
  VkRenderingAttachmentInfo colour{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  colour.imageView = from.view;
  colour.imageLayout = colour.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
  colour.resolveImageView = to.view;
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea = {{0, 0}, from.extent};
  info.layerCount = 1;
  info.colorAttachmentCount = 1;
  info.pColorAttachments = &colour;
  vk_.vkCmdBeginRendering(commands, &info);
  vk_.vkCmdEndRendering(commands);
}

std::vector<std::byte> Host::read(HostImage& image) {
  const gpu::TextureDesc desc{
      .width = image.extent.width, .height = image.extent.height, .format = image.format};
  const HostBuffer into = buffer(gpu::bytes_of(desc), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  run([&](VkCommandBuffer commands) {
    transition(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy region{};
    region.imageSubresource = {gpu::aspect_of(image.format), 0, 0, 1};
    region.imageExtent = {image.extent.width, image.extent.height, 1};
    vk_.vkCmdCopyImageToBuffer(commands, image.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, into.handle, 1,
                               &region);
  });
  return {into.mapped, into.mapped + into.bytes};
}

}  // namespace dermis::tests
