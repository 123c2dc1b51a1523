// SPDX-License-Identifier: MIT
/// What an engine has before it meets dermis: a device, memory, command buffers of frames in flight. Plain
/// Vulkan 1.3, as short as it goes; dermis appears in the constructor of Device and in Device::host() alone.
/// Everything here throws std::runtime_error where Vulkan says no.
#pragma once

#include <dermis/vulkan.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace host {

void check(VkResult result, const char* call);

/// Owns a handle of a device: destroys it with the function it was given.
template <class Handle>
class Owned {
 public:
  using Destroy = void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*);
  Owned() = default;
  Owned(VkDevice device, Handle handle, Destroy destroy)
      : device_(device), handle_(handle), destroy_(destroy) {}
  Owned(Owned&& other) noexcept { *this = std::move(other); }
  Owned& operator=(Owned&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  ~Owned() {
    if (handle_) destroy_(device_, handle_, nullptr);
  }
  Handle get() const { return handle_; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

/// A 2D image of one layer and level in memory of its own, and the layout that transition() left it in.
struct Image {
  Owned<VkDeviceMemory> memory;
  Owned<VkImage> image;
  Owned<VkImageView> view;  ///< of depth alone, if there is stencil too
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{};
  VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// A buffer that the processor sees at `mapped`, coherently.
struct Buffer {
  Owned<VkDeviceMemory> memory;
  Owned<VkBuffer> buffer;
  VkDeviceSize bytes = 0;
  std::byte* mapped = nullptr;
};

/// Instance, device and one queue. Outlives whatever was made with it.
class Device {
 public:
  /// Takes the fastest kind of device that has what dermis needs. `validate`: under the validation layer,
  /// with synchronization validation, where the layer is installed.
  explicit Device(bool validate);
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkDevice handle() const { return vk_.device; }
  VkQueue queue() const { return queue_; }
  std::uint32_t queue_family() const { return queue_family_; }
  std::string name() const;
  dermis::vulkan::Host host() const;  ///< what dermis::Renderer takes

  bool validated() const { return vk_.messenger != VK_NULL_HANDLE; }
  /// What the validation layer has said so far, one element per message; standard error has it too.
  const std::vector<std::string>& messages() const { return messages_; }

  /// `samples` above 1: only to be drawn to and resolved.
  Image make_image(VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
                   std::uint32_t samples = 1) const;
  Buffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) const;
  /// A buffer with the elements of a container in it.
  template <class Container>
  Buffer make_buffer_of(const Container& elements, VkBufferUsageFlags usage) const {
    Buffer made = make_buffer(elements.size() * sizeof(*elements.data()), usage);
    const auto* bytes = reinterpret_cast<const std::byte*>(elements.data());
    std::copy(bytes, bytes + made.bytes, made.mapped);
    return made;
  }

  /// Records commands, submits them and waits: for uploads and the like, not for frames.
  void run(const std::function<void(VkCommandBuffer)>& record) const;
  /// Returns the texels of an image of one sample that has TRANSFER_SRC usage: rows from top to bottom,
  /// without gaps. Waits for all that was submitted before.
  std::vector<std::byte> read(Image& image, std::size_t bytes_per_texel) const;

 private:
  /// What everything else depends on: destroyed last, also where a constructor throws.
  struct Handles {
    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    ~Handles();
  };
  void make_instance(bool validate);
  void make_device();
  VkResult try_device(VkPhysicalDevice physical);
  Owned<VkDeviceMemory> allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags properties) const;

  std::vector<std::string> messages_;
  Handles vk_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
  VkQueue queue_ = VK_NULL_HANDLE;
  std::uint32_t queue_family_ = 0;
  bool sampler_anisotropy_ = false;
  Owned<VkCommandPool> pool_;
};

/// Command buffers for frames of which several are in flight. The device counts finished frames in a timeline
/// semaphore; frames are numbered from 1, as dermis wants them.
///
///   const Frames::Frame frame = frames.begin();
///   heads.record(frame.commands, views, frame.numbers);
///   frames.submit();
class Frames {
 public:
  Frames(const Device& device, std::uint32_t in_flight);
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;
  ~Frames();  ///< waits for all frames

  struct Frame {
    VkCommandBuffer commands = VK_NULL_HANDLE;  ///< begun
    dermis::vulkan::FrameNumbers numbers{};
    std::uint32_t slot = 0;  ///< below in_flight: which of what there is several times is free
  };
  /// Waits until the frame that used this slot before has finished.
  Frame begin();
  void submit();
  /// Waits for all frames: before what they use is destroyed.
  void wait() const { wait_for(number_); }

 private:
  void wait_for(std::uint64_t frame) const;

  struct Slot {
    Owned<VkCommandPool> pool;
    VkCommandBuffer commands = VK_NULL_HANDLE;
  };
  const Device* device_;
  std::vector<Slot> slots_;
  Owned<VkSemaphore> finished_;
  std::uint64_t number_ = 0;  ///< of the frame begun last
};

/// Changes the layout of an image, after all that was recorded before and before all that follows. What it
/// held stays, unless `layout` is UNDEFINED in the image.
void transition(VkCommandBuffer commands, Image& image, VkImageLayout layout);

/// Begins to draw to these images; one may be null. Values: clear to them; none: keep what is there. Sets
/// viewport and scissor to all of the image. End with vkCmdEndRendering().
void begin_rendering(VkCommandBuffer commands, const Image* colour, const Image* depth,
                     const std::optional<std::array<float, 4>>& clear_colour = {},
                     const std::optional<float>& clear_depth = {});

}  // namespace host
