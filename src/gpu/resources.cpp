// SPDX-License-Identifier: MIT
#include "gpu/resources.h"

#include <algorithm>
#include <utility>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "gpu/device.h"
#include "gpu/formats.h"
#include "gpu/memory.h"
#include "gpu/mib.h"
#include "gpu/raw.h"

namespace dermis::gpu {
namespace {

constexpr VkImageUsageFlags target_usage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;

template <class Handle>
std::uint64_t as_number(Handle handle) {
  return reinterpret_cast<std::uint64_t>(handle);
}

/// Returns the arguments of vkCreateImage. Textures of one sample always allow transfers, for uploads,
/// read-backs and clears.
VkImageCreateInfo image_info(const TextureDesc& desc) {
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = desc.format;
  info.extent = {desc.width, desc.height, 1};
  info.mipLevels = desc.mips;
  info.arrayLayers = desc.layers;
  info.samples = static_cast<VkSampleCountFlagBits>(desc.samples);
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = desc.usage;
  if (desc.samples == 1) info.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  return info;
}

/// Throws DeviceError if the device cannot have such a texture; names the limit and what it allows.
void check_texture_limits(const Device& device, const std::string& name, const TextureDesc& desc,
                          VkImageUsageFlags usage) {
  DERMIS_ASSERT(desc.width > 0 && desc.height > 0 && desc.layers > 0 && desc.mips > 0 &&
                (desc.samples == 1 || desc.samples == 4));

  const DeviceLimits& limits = device.limits();
  if (desc.width > limits.max_image_side || desc.height > limits.max_image_side)
    throw device_error("'{}' would be {}x{} texels; {} allows {} per side", name, desc.width, desc.height,
                       device.summary().name, limits.max_image_side);
  if (desc.layers > limits.max_array_layers)
    throw device_error("'{}' would have {} layers; {} allows {}", name, desc.layers, device.summary().name,
                       limits.max_array_layers);

  // A format may allow less for these uses than the limits of the device.
  const std::optional<VkImageFormatProperties> can = device.image_format_properties(desc.format, usage);
  if (!can)
    throw device_error("'{}' needs {} images for the uses {:#x}, which {} does not have", name,
                       format_name(desc.format), usage, device.summary().name);
  if (!(can->sampleCounts & desc.samples))
    throw device_error("'{}' needs {} samples of {}, which {} does not have", name, desc.samples,
                       format_name(desc.format), device.summary().name);

  DERMIS_ASSERT_LE(desc.mips, can->maxMipLevels);
  if (bytes_of(desc) > can->maxResourceSize)
    throw device_error("no device memory for '{}': needed {:.1f} MiB; {} allows {:.1f} MiB in one image",
                       name, mib(bytes_of(desc)), device.summary().name, mib(can->maxResourceSize));
  if (desc.width > can->maxExtent.width || desc.height > can->maxExtent.height ||
      desc.layers > can->maxArrayLayers)
    throw device_error("'{}' would be {}x{} texels in {} layers; {} allows {}x{} in {} for {}", name,
                       desc.width, desc.height, desc.layers, device.summary().name, can->maxExtent.width,
                       can->maxExtent.height, can->maxArrayLayers, format_name(desc.format));
}

VkImageView make_view(Device& device, VkImage image, const TextureDesc& desc, VkImageViewType type,
                      VkImageSubresourceRange range) {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image;
  info.viewType = type;
  info.format = desc.format;
  info.subresourceRange = range;
  // Views to render into have the channels as they are.
  if (desc.grey_alpha && type == VK_IMAGE_VIEW_TYPE_2D_ARRAY)
    info.components = {VK_COMPONENT_SWIZZLE_R, VK_COMPONENT_SWIZZLE_R, VK_COMPONENT_SWIZZLE_R,
                       VK_COMPONENT_SWIZZLE_G};
  VkImageView view = VK_NULL_HANDLE;
  check(device.vk().vkCreateImageView(device.handle(), &info, nullptr, &view), "vkCreateImageView");
  return view;
}

}  // namespace

RawBuffer create_raw_buffer(Device& device, const std::string& name, const BufferDesc& desc) {
  // Within the limits of the device?
  DERMIS_ASSERT(desc.bytes > 0);
  if (desc.bytes > device.limits().max_buffer_bytes)
    throw device_error("'{}' would be {} bytes; {} allows {} in one buffer", name, desc.bytes,
                       device.summary().name, device.limits().max_buffer_bytes);
  if ((desc.usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) &&
      desc.bytes > device.limits().max_storage_buffer_bytes)
    throw device_error("'{}' would be {} bytes; {} allows shaders {} in one buffer", name, desc.bytes,
                       device.summary().name, device.limits().max_storage_buffer_bytes);

  if (desc.usage & VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT) {
    const std::uint64_t texels = desc.bytes / texel_bytes(texel_format);
    DERMIS_ASSERT_EQ(desc.bytes, texels * texel_bytes(texel_format));
    if (texels > device.limits().max_texel_buffer_texels)
      throw device_error("'{}' would be {} texels; {} allows {} in one buffer", name, texels,
                         device.summary().name, device.limits().max_texel_buffer_texels);
  }

  // The buffer without memory.
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = desc.bytes;
  info.usage = desc.usage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  RawBuffer raw;
  check(device.vk().vkCreateBuffer(device.handle(), &info, nullptr, &raw.handle),
        fmt::format("vkCreateBuffer for '{}' ({:.1f} MiB)", name, mib(desc.bytes)));
  ++device.counters().buffers;

  // Memory, as a part of a block that the pool shares out.
  try {
    raw.allocation = device.memory().allocate_buffer(name, raw.handle, desc.place);
    check(device.vk().vkBindBufferMemory(device.handle(), raw.handle, raw.allocation->memory,
                                         raw.allocation->offset),
          "vkBindBufferMemory");
  } catch (...) {
    destroy_raw_buffer(device, raw);
    throw;
  }

  device.set_name(VK_OBJECT_TYPE_BUFFER, as_number(raw.handle), name);
  return raw;
}

void destroy_raw_buffer(Device& device, const RawBuffer& buffer) {
  device.vk().vkDestroyBuffer(device.handle(), buffer.handle, nullptr);
  if (buffer.allocation) device.memory().free(buffer.allocation);
}

Buffer::Buffer(Device& device, std::string name, const BufferDesc& desc)
    : device_(&device), name_(std::move(name)), desc_(desc) {
  const RawBuffer raw = create_raw_buffer(device, name_, desc);
  handle_ = raw.handle;
  allocation_ = raw.allocation;
  if (desc.usage & VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT) make_texel_view();
}

void Buffer::make_texel_view() {
  VkBufferViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
  info.buffer = handle_;
  info.format = texel_format;
  info.range = VK_WHOLE_SIZE;
  const VkResult result = device_->vk().vkCreateBufferView(device_->handle(), &info, nullptr, &texel_view_);
  if (result != VK_SUCCESS) release();
  check(result, "vkCreateBufferView");
}

Buffer::Buffer(Buffer&& other) noexcept { *this = std::move(other); }

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  if (this == &other) return *this;
  release();
  device_ = std::exchange(other.device_, nullptr);
  name_ = std::move(other.name_);
  desc_ = std::exchange(other.desc_, {});
  handle_ = std::exchange(other.handle_, VK_NULL_HANDLE);
  texel_view_ = std::exchange(other.texel_view_, VK_NULL_HANDLE);
  allocation_ = std::exchange(other.allocation_, nullptr);
  return *this;
}

Buffer::~Buffer() { release(); }

void Buffer::release() {
  if (!handle_ || !device_) return;
  const RawBuffer raw{std::exchange(handle_, VK_NULL_HANDLE),
                      static_cast<MemoryPool::Allocation*>(std::exchange(allocation_, nullptr))};
  device_->retire([device = device_, raw, view = std::exchange(texel_view_, VK_NULL_HANDLE)] {
    device->vk().vkDestroyBufferView(device->handle(), view, nullptr);
    destroy_raw_buffer(*device, raw);
  });
}

std::span<std::byte> Buffer::mapped() const {
  DERMIS_ASSERT(handle_ != VK_NULL_HANDLE && desc_.place != BufferPlace::device);
  return {static_cast<const MemoryPool::Allocation*>(allocation_)->mapped, desc_.bytes};
}

Texture::Texture(Device& device, std::string name, const TextureDesc& desc)
    : device_(&device), name_(std::move(name)), desc_(desc) {
  // The image without memory.
  const VkImageCreateInfo info = image_info(desc);
  check_texture_limits(device, name_, desc, info.usage);
  check(device.vk().vkCreateImage(device.handle(), &info, nullptr, &handle_),
        fmt::format("vkCreateImage for '{}' ({:.1f} MiB)", name_, mib(bytes_of(desc))));
  ++device.counters().images;

  // From here on the image has to be given back if a step fails: no destructor runs for what a constructor
  // leaves half made.
  try {
    auto* allocation = device.memory().allocate_image(name_, handle_);
    allocation_ = allocation;
    check(device.vk().vkBindImageMemory(device.handle(), handle_, allocation->memory, allocation->offset),
          "vkBindImageMemory");

    // One view of all for shaders. Images only for transfers must not have one.
    const VkImageAspectFlags aspect = aspect_of(desc.format);
    const bool viewable =
        (desc.usage & (target_usage | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT)) != 0;
    const VkImageViewType type =
        desc.array || desc.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
    if (viewable) view_ = make_view(device, handle_, desc, type, {aspect, 0, desc.mips, 0, desc.layers});

    // One view per layer to render into.
    for (std::uint32_t layer = 0; (desc.usage & target_usage) && layer < desc.layers; ++layer)
      layer_views_.push_back(
          make_view(device, handle_, desc, VK_IMAGE_VIEW_TYPE_2D, {aspect, 0, 1, layer, 1}));
  } catch (...) {
    release();
    throw;
  }

  device.set_name(VK_OBJECT_TYPE_IMAGE, as_number(handle_), name_);
  if (view_) device.set_name(VK_OBJECT_TYPE_IMAGE_VIEW, as_number(view_), name_);
}

Texture::Texture(std::string name, const TextureDesc& desc, VkImageView of_host)
    : name_(std::move(name)), desc_(desc), view_(of_host), layer_views_{of_host} {}

Texture::Texture(Texture&& other) noexcept { *this = std::move(other); }

Texture& Texture::operator=(Texture&& other) noexcept {
  if (this == &other) return *this;
  release();
  device_ = std::exchange(other.device_, nullptr);
  name_ = std::move(other.name_);
  desc_ = std::exchange(other.desc_, {});
  handle_ = std::exchange(other.handle_, VK_NULL_HANDLE);
  view_ = std::exchange(other.view_, VK_NULL_HANDLE);
  layer_views_ = std::exchange(other.layer_views_, {});
  allocation_ = std::exchange(other.allocation_, nullptr);
  return *this;
}

Texture::~Texture() { release(); }

void Texture::release() {
  if (!handle_) return;
  auto views = std::exchange(layer_views_, {});
  views.push_back(std::exchange(view_, VK_NULL_HANDLE));
  auto* allocation = static_cast<MemoryPool::Allocation*>(std::exchange(allocation_, nullptr));

  device_->retire([device = device_, image = std::exchange(handle_, VK_NULL_HANDLE), views = std::move(views),
                   allocation] {
    for (VkImageView view : views) device->vk().vkDestroyImageView(device->handle(), view, nullptr);
    device->vk().vkDestroyImage(device->handle(), image, nullptr);
    if (allocation) device->memory().free(allocation);
  });
}

VkImageView Texture::layer_view(std::uint32_t layer) const {
  DERMIS_ASSERT_LT(layer, layer_views_.size());
  return layer_views_[layer];
}

}  // namespace dermis::gpu
