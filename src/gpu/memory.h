// SPDX-License-Identifier: MIT
// Allocates device memory in blocks. Each block serves one memory type and one kind of resource (linear or
// optimal), so that neighbours never share a page of bufferImageGranularity. Large resources get their own
// memory. One thread at a time. A host may do the allocating: each resource is a request to it then.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "dermis/vulkan.h"
#include "gpu/resources.h"
#include "gpu/vulkan.h"

namespace dermis::gpu {

class MemoryPool {
 public:
  static constexpr std::uint64_t block_bytes = std::uint64_t{64} << 20;

  struct Block;
  struct Allocation {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::uint64_t offset = 0;  ///< of the resource
    std::uint64_t bytes = 0;
    std::byte* mapped = nullptr;  ///< upload and readback only
    bool image = false;
    Block* block = nullptr;     ///< null: of the host
    vulkan::MemoryRange range;  ///< of the host
  };

  MemoryPool(const DeviceTable& vk, VkDevice device, const VkPhysicalDeviceMemoryProperties& properties,
             std::uint64_t max_allocation_bytes, vulkan::MemoryCallbacks of_host = {});
  MemoryPool(const MemoryPool&) = delete;
  MemoryPool& operator=(const MemoryPool&) = delete;
  ~MemoryPool();  ///< warns if something was not freed

  /// Return memory for a buffer or an image; the caller binds it. Throw DeviceError if it does not fit (names
  /// the size and the heap).
  Allocation* allocate_buffer(const std::string& name, VkBuffer buffer, BufferPlace place);
  Allocation* allocate_image(const std::string& name, VkImage image);
  /// Warns of memory that is not, or no longer, of this pool: destructors call it.
  void free(Allocation* allocation) noexcept;

  const VkPhysicalDeviceMemoryProperties& properties() const { return properties_; }
  std::uint64_t image_bytes() const { return image_bytes_; }
  std::uint64_t buffer_bytes() const { return buffer_bytes_; }
  std::uint64_t peak_bytes() const { return peak_bytes_; }    ///< largest sum of the two so far
  std::uint64_t reserved_bytes() const;                       ///< currently allocated from the driver
  std::uint64_t allocations() const { return allocations_; }  ///< from the driver, so far

 private:
  struct Request;
  Allocation* allocate(const Request& request);
  std::unique_ptr<Allocation> try_allocate(const Request& request, const std::vector<std::uint32_t>& types);
  Block* new_block(const Request& request, std::uint32_t type, std::uint64_t bytes, bool dedicated);
  std::unique_ptr<Allocation> place_in(Block& block, const Request& request);
  std::unique_ptr<Allocation> ask_host(const Request& request, const std::vector<std::uint32_t>& types);
  std::vector<std::uint32_t> types_for(std::uint32_t allowed, BufferPlace place) const;
  void map(Block& block);
  void release(Block* block);
  bool release_empty();  ///< returns whether there was one

  const DeviceTable* vk_;
  VkDevice device_;
  VkPhysicalDeviceMemoryProperties properties_;
  std::uint64_t max_allocation_bytes_;
  vulkan::MemoryCallbacks of_host_;
  std::vector<std::unique_ptr<Block>> blocks_;
  std::array<std::uint64_t, VK_MAX_MEMORY_HEAPS> heap_used_{};
  std::uint64_t image_bytes_ = 0, buffer_bytes_ = 0, peak_bytes_ = 0;
  std::uint64_t allocations_ = 0;
  std::unordered_map<Allocation*, std::unique_ptr<Allocation>> live_;
};

}  // namespace dermis::gpu
