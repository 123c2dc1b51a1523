// SPDX-License-Identifier: MIT
// Memory that the host writes anew for every frame, in one buffer: many small
// arrays, one copy to the device. There is no allocation once it is as large as a frame needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/cmd.h"
#include "gpu/resources.h"

namespace dermis::gpu {

class Device;

/// Neither copied nor moved: bindings point at it. `device` must outlive it.
class FrameMemory {
 public:
  FrameMemory(Device& device, std::string name) : device_(&device), name_(std::move(name)) {}
  FrameMemory(const FrameMemory&) = delete;
  FrameMemory& operator=(const FrameMemory&) = delete;

  /// Forgets all arrays; the GPU must have done with those of the last frame.
  void clear() { bytes_.clear(); }

  /// Adds an array and returns where it will lie, as a uniform or a storage buffer. The binding is valid
  /// until clear(). Without data: one element that is zero, because Vulkan has no empty buffers.
  template <class T>
  BufferBinding add(std::span<const T> data) {
    return add_bytes(std::as_bytes(data), sizeof(T));
  }
  /// Writes over an array that has as many elements.
  template <class T>
  void replace(const BufferBinding& binding, std::span<const T> data) {
    replace_bytes(binding, std::as_bytes(data));
  }

  /// Returns all arrays as texels of texel_format: the one that add() places at an offset begins at this
  /// offset over 16.
  BufferBinding texels() const { return {&on_device_}; }

  std::uint64_t bytes() const { return bytes_.size(); }  ///< of all arrays
  /// Makes buffers for arrays of so many bytes, so that record() does not. Throws DeviceError if memory does
  /// not suffice.
  void reserve(std::uint64_t bytes);

  /// Records the copy of all arrays to the device, and the barrier after it. Makes larger buffers first if
  /// they have grown; throws DeviceError if memory does not suffice.
  void record(VkCommandBuffer commands);
  /// Copies them and waits until done.
  void upload();

 private:
  BufferBinding add_bytes(std::span<const std::byte> bytes, std::size_t element_bytes);
  void replace_bytes(const BufferBinding& binding, std::span<const std::byte> bytes);

  Device* device_;
  std::string name_;
  std::vector<std::byte> bytes_;
  Buffer staging_, on_device_;
};

}  // namespace dermis::gpu
