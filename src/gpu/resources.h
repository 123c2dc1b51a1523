// SPDX-License-Identifier: MIT
// Move-only buffers and textures. Each owns its Vulkan objects and its memory, and must be destroyed before
// its device. The destructor passes them to Device::retire, so they live as long as the GPU needs them. The
// name is used for the debug label, validation messages and the memory report.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace dermis::gpu {

class Device;

/// Where a buffer lies: in memory that the GPU reads fastest, or in memory of the host for one direction.
/// `upload` and `readback` stay mapped.
enum class BufferPlace : std::uint8_t { device, upload, readback };

/// Of buffers whose usage has UNIFORM_TEXEL_BUFFER: 16 bytes, as they are. Where invocations read at places
/// of their own, the software driver takes as long for a texel as for one float of a storage buffer
/// (docs/notes/performance.md).
inline constexpr VkFormat texel_format = VK_FORMAT_R32G32B32A32_UINT;
/// The usage of buffers that some shaders read as texels and others as structures.
inline constexpr VkBufferUsageFlags texels_of_shaders =
    VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;

struct BufferDesc {
  std::uint64_t bytes = 0;       ///< > 0; whole texels, if it is read as such
  VkBufferUsageFlags usage = 0;  ///< transfer bits are added
  BufferPlace place = BufferPlace::device;
  bool operator==(const BufferDesc&) const = default;
};

class Buffer {
 public:
  Buffer() = default;  ///< empty: converts to false
  /// Throws DeviceError if over a limit of the device, or if memory does not suffice (names the size). The
  /// contents are undefined.
  Buffer(Device& device, std::string name, const BufferDesc& desc);
  /// A host's buffer, which it owns; may be null.
  Buffer(std::string name, VkBuffer of_host) : name_(std::move(name)), handle_(of_host) {}
  Buffer(Buffer&&) noexcept;
  Buffer& operator=(Buffer&&) noexcept;
  ~Buffer();

  explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
  VkBuffer handle() const { return handle_; }
  const BufferDesc& desc() const { return desc_; }
  const std::string& name() const { return name_; }
  /// Returns the buffer as texels of texel_format; null if its usage has no UNIFORM_TEXEL_BUFFER.
  VkBufferView texel_view() const { return texel_view_; }
  /// Returns the bytes as the host sees them; coherent, so without flushes. Asserts that the buffer is of the
  /// place `upload` or `readback`.
  std::span<std::byte> mapped() const;

 private:
  void make_texel_view();
  void release();

  Device* device_ = nullptr;
  std::string name_;
  BufferDesc desc_;
  VkBuffer handle_ = VK_NULL_HANDLE;
  VkBufferView texel_view_ = VK_NULL_HANDLE;
  void* allocation_ = nullptr;  ///< owned by the device's MemoryPool
};

struct TextureDesc {
  std::uint32_t width = 0, height = 0;  ///< of mip 0, texels, > 0
  std::uint32_t layers = 1;             ///< > 0
  std::uint32_t mips = 1;               ///< levels, > 0
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::uint32_t samples = 1;    ///< per texel, 1 or 4
  VkImageUsageFlags usage = 0;  ///< transfer bits are added, unless there are 4 samples
  bool array = false;           ///< view type 2D_ARRAY even with one layer
  bool grey_alpha = false;      ///< shaders read the two channels as grey and alpha
  bool operator==(const TextureDesc&) const = default;
};

/// Returns the size of all mips, layers and samples, without the padding that a driver may add.
std::uint64_t bytes_of(const TextureDesc& desc);
std::uint64_t texels_of(const TextureDesc& desc);  ///< of all layers and mip levels
/// Returns the depth aspect of depth formats, else the colour aspect.
VkImageAspectFlags aspect_of(VkFormat format);

class Texture {
 public:
  Texture() = default;  ///< empty: converts to false
  /// Throws DeviceError if over a limit of the device, or if memory does not suffice (names size and limit).
  /// Contents and layout are undefined.
  Texture(Device& device, std::string name, const TextureDesc& desc);
  /// A view of a host's image, whole: one layer and level if it is drawn to. Owns nothing. `desc`: its size
  /// and format.
  Texture(std::string name, const TextureDesc& desc, VkImageView of_host);
  Texture(Texture&&) noexcept;
  Texture& operator=(Texture&&) noexcept;
  ~Texture();

  explicit operator bool() const { return view_ != VK_NULL_HANDLE || handle_ != VK_NULL_HANDLE; }
  VkImage handle() const { return handle_; }  ///< null of a host's
  VkImageView view() const { return view_; }  ///< all layers and mips; null if only for transfers
  /// Returns the view of one layer, mip 0, 2D, to render into. Asserts that `usage` has an attachment bit.
  VkImageView layer_view(std::uint32_t layer) const;
  const TextureDesc& desc() const { return desc_; }
  const std::string& name() const { return name_; }

 private:
  void release();

  Device* device_ = nullptr;
  std::string name_;
  TextureDesc desc_;
  VkImage handle_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  std::vector<VkImageView> layer_views_;
  void* allocation_ = nullptr;  ///< owned by the device's MemoryPool
};

/// Fill a buffer or texture from host memory through a staging buffer, and wait until done. Buffer: from its
/// beginning, at most its size. Texture: mips one after the other, each tightly packed (layers inside); one
/// sample, usage SAMPLED; it ends in SHADER_READ_ONLY_OPTIMAL. Throw DeviceError if staging does not fit.
void upload(Device& device, const Buffer& to, std::span<const std::byte> bytes);
void upload(Device& device, const Texture& to, std::span<const std::byte> bytes);
/// Return the contents of a buffer, or mip 0 of one layer of a texture, tightly packed. Wait until done. The
/// texture must be in `layout` and returns to it.
std::vector<std::byte> read_back(Device& device, const Texture& from, VkImageLayout layout,
                                 std::uint32_t layer = 0);
std::vector<std::byte> read_back(Device& device, const Buffer& from);

/// For tests: fills a texture of one sample with values that a driver might leave and no reader may use: NaN
/// if the format has it, 0.5 in a depth. Waits until done. The layout is undefined afterwards.
void poison(Device& device, const Texture& texture);

/// Returns a device buffer filled with `data`; without data, a buffer of one element that is not filled,
/// because Vulkan has no empty buffers.
template <class T>
Buffer make_buffer(Device& device, std::string name, std::span<const T> data, VkBufferUsageFlags usage) {
  Buffer buffer(device, std::move(name),
                {.bytes = std::max<std::uint64_t>(data.size_bytes(), sizeof(T)), .usage = usage});
  if (!data.empty()) upload(device, buffer, std::as_bytes(data));
  return buffer;
}

enum class Filter : std::uint8_t { nearest, linear };
enum class Address : std::uint8_t { repeat, clamp, mirror };
/// For PipelineLibrary::sampler().
struct SamplerDesc {
  Filter filter = Filter::linear;  ///< also for mip levels
  Address u = Address::clamp, v = Address::clamp;
  bool compare_greater = false;  ///< reversed-Z shadow comparison (GREATER_OR_EQUAL)
  float max_anisotropy = 1;      ///< clamped to the device's limit
  bool operator==(const SamplerDesc&) const = default;
};

}  // namespace dermis::gpu
