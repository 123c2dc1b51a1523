// SPDX-License-Identifier: MIT
#include "gpu/memory.h"

#include <algorithm>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <utility>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "gpu/device.h"
#include "gpu/mib.h"

namespace dermis::gpu {

namespace {

/// Unused ranges of a block, none beside another. A search does not walk over those that are too small:
/// thousands of buffers leave a remnant between any two of them.
class FreeRanges {
 public:
  using Range = std::pair<std::uint64_t, std::uint64_t>;  ///< offset, bytes

  void add(std::uint64_t offset, std::uint64_t bytes) {
    by_size_.emplace(bytes, offset);
    by_offset_.emplace(offset, bytes);
  }
  void remove(const Range& range) {
    by_size_.erase({range.second, range.first});
    by_offset_.erase(range.first);
  }
  /// Returns one of the smallest that hold so many bytes at a multiple of `alignment`.
  std::optional<Range> holding(std::uint64_t bytes, std::uint64_t alignment) const;
  /// Adds a range and merges it with its neighbours.
  void give_back(std::uint64_t offset, std::uint64_t bytes);
  bool is_whole(std::uint64_t bytes) const {
    return by_offset_.size() == 1 && by_offset_.begin()->second == bytes;
  }

 private:
  std::map<std::uint64_t, std::uint64_t> by_offset_;           ///< -> bytes
  std::set<std::pair<std::uint64_t, std::uint64_t>> by_size_;  ///< bytes, offset
};

std::uint64_t align_up(std::uint64_t offset, std::uint64_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}

std::optional<FreeRanges::Range> FreeRanges::holding(std::uint64_t bytes, std::uint64_t alignment) const {
  constexpr int most_tried = 8;  // of those that hold it only if they begin at the right place
  auto at = by_size_.lower_bound({bytes, 0});
  for (int i = 0; i < most_tried && at != by_size_.end(); ++i, ++at)
    if (align_up(at->second, alignment) + bytes <= at->second + at->first)
      return Range(at->second, at->first);
  at = by_size_.lower_bound({bytes + alignment - 1, 0});
  if (at == by_size_.end()) return std::nullopt;
  return Range(at->second, at->first);
}

void FreeRanges::give_back(std::uint64_t offset, std::uint64_t bytes) {
  Range merged(offset, bytes);
  const auto next = by_offset_.lower_bound(offset);
  if (next != by_offset_.begin()) {
    const Range before = *std::prev(next);
    if (before.first + before.second == offset) {
      merged = {before.first, before.second + merged.second};
      remove(before);
    }
  }
  if (const auto after = by_offset_.find(offset + bytes); after != by_offset_.end()) {
    merged.second += after->second;
    remove(Range(*after));
  }
  add(merged.first, merged.second);
}

}  // namespace

struct MemoryPool::Block {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  std::uint32_t type = 0;
  std::uint64_t bytes = 0;
  std::byte* mapped = nullptr;
  bool image = false;
  bool dedicated = false;
  FreeRanges free;
  bool is_empty() const { return free.is_whole(bytes); }
};

struct MemoryPool::Request {
  std::string name;
  VkMemoryRequirements needs{};
  BufferPlace place = BufferPlace::device;
  bool dedicated = false;
  VkImage image = VK_NULL_HANDLE;
  VkBuffer buffer = VK_NULL_HANDLE;
};

MemoryPool::MemoryPool(const DeviceTable& vk, VkDevice device,
                       const VkPhysicalDeviceMemoryProperties& properties, std::uint64_t max_allocation_bytes,
                       vulkan::MemoryCallbacks of_host)
    : vk_(&vk),
      device_(device),
      properties_(properties),
      max_allocation_bytes_(max_allocation_bytes),
      of_host_(std::move(of_host)) {}

MemoryPool::~MemoryPool() {
  static_cast<void>(DERMIS_HOLDS(live_.empty()));
  while (!blocks_.empty()) release(blocks_.back().get());
}

std::uint64_t MemoryPool::reserved_bytes() const {
  std::uint64_t sum = 0;
  for (const auto& block : blocks_) sum += block->bytes;
  return sum;
}

std::vector<std::uint32_t> MemoryPool::types_for(std::uint32_t allowed, BufferPlace place) const {
  constexpr VkMemoryPropertyFlags coherent =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

  // Staging avoids device memory, of which only a part may be visible; reading uncached memory is slow.
  struct Wish {
    VkMemoryPropertyFlags with, without;
  };
  std::vector<Wish> wishes;
  switch (place) {
    case BufferPlace::device:
      wishes = {{VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0}, {0, VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT}};
      break;
    case BufferPlace::upload:
      wishes = {{coherent, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT}, {coherent, 0}};
      break;
    case BufferPlace::readback:
      wishes = {{coherent | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, 0}, {coherent, 0}};
      break;
  }

  // Takes the first wish that a type fulfils, with its types in the driver's order.
  for (const Wish& wish : wishes) {
    std::vector<std::uint32_t> types;
    for (std::uint32_t i = 0; i < properties_.memoryTypeCount; ++i) {
      const VkMemoryPropertyFlags flags = properties_.memoryTypes[i].propertyFlags;
      if ((allowed >> i & 1u) && (flags & wish.with) == wish.with && !(flags & wish.without))
        types.push_back(i);
    }
    if (!types.empty()) return types;
  }
  return {};
}

void MemoryPool::map(Block& block) {
  if (block.mapped) return;
  void* address = nullptr;
  check(vk_->vkMapMemory(device_, block.memory, 0, VK_WHOLE_SIZE, 0, &address), "vkMapMemory");
  block.mapped = static_cast<std::byte*>(address);
}

MemoryPool::Block* MemoryPool::new_block(const Request& request, std::uint32_t type, std::uint64_t bytes,
                                         bool dedicated) {
  const std::uint32_t heap = properties_.memoryTypes[type].heapIndex;
  if (bytes > max_allocation_bytes_ || heap_used_[heap] + bytes > properties_.memoryHeaps[heap].size)
    return nullptr;

  VkMemoryDedicatedAllocateInfo alone{};
  alone.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO;
  alone.image = request.image;
  alone.buffer = request.buffer;
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.pNext = dedicated ? &alone : nullptr;
  info.allocationSize = bytes;
  info.memoryTypeIndex = type;

  VkDeviceMemory memory = VK_NULL_HANDLE;
  const VkResult result = vk_->vkAllocateMemory(device_, &info, nullptr, &memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) return nullptr;
  check(result, "vkAllocateMemory");
  ++allocations_;

  auto block = std::make_unique<Block>();
  block->memory = memory;
  block->type = type;
  block->bytes = bytes;
  block->image = request.image != VK_NULL_HANDLE;
  block->dedicated = dedicated;
  block->free.add(0, bytes);

  heap_used_[heap] += bytes;
  return blocks_.emplace_back(std::move(block)).get();
}

std::unique_ptr<MemoryPool::Allocation> MemoryPool::place_in(Block& block, const Request& request) {
  const auto range = block.free.holding(request.needs.size, request.needs.alignment);
  if (!range) return nullptr;
  if (request.place != BufferPlace::device) map(block);

  const auto [start, bytes] = *range;
  const std::uint64_t offset = align_up(start, request.needs.alignment);
  const std::uint64_t end = offset + request.needs.size;
  block.free.remove(*range);
  if (offset > start) block.free.add(start, offset - start);
  if (end < start + bytes) block.free.add(end, start + bytes - end);
  return std::make_unique<Allocation>(
      Allocation{.memory = block.memory,
                 .offset = offset,
                 .bytes = request.needs.size,
                 .mapped = request.place == BufferPlace::device ? nullptr : block.mapped + offset,
                 .image = block.image,
                 .block = &block});
}

std::unique_ptr<MemoryPool::Allocation> MemoryPool::try_allocate(const Request& request,
                                                                 const std::vector<std::uint32_t>& types) {
  if (of_host_.allocate) return ask_host(request, types);
  const bool image = request.image != VK_NULL_HANDLE;
  const std::uint64_t bytes = request.needs.size;
  for (const std::uint32_t type : types) {
    const std::uint64_t heap_bytes = properties_.memoryHeaps[properties_.memoryTypes[type].heapIndex].size;
    const std::uint64_t usual = std::min(block_bytes, heap_bytes / 8);
    const bool dedicated = request.dedicated || bytes > usual / 2;
    for (const auto& block : blocks_) {
      if (dedicated || block->dedicated || block->type != type || block->image != image) continue;
      if (std::unique_ptr<Allocation> made = place_in(*block, request)) return made;
    }
    Block* block = new_block(request, type, dedicated ? bytes : usual, dedicated);
    // A heap without room for a block may have room for this one resource.
    if (!block && !dedicated) block = new_block(request, type, bytes, true);
    if (block) return place_in(*block, request);
  }
  return nullptr;
}

std::unique_ptr<MemoryPool::Allocation> MemoryPool::ask_host(const Request& request,
                                                             const std::vector<std::uint32_t>& types) {
  const bool mapped = request.place != BufferPlace::device;
  vulkan::MemoryRequest wanted{.requirements = request.needs,
                               .mapped = mapped,
                               .dedicated = request.dedicated,
                               .buffer = request.buffer,
                               .image = request.image,
                               .name = request.name.c_str()};
  wanted.requirements.memoryTypeBits = 0;
  for (const std::uint32_t type : types) wanted.requirements.memoryTypeBits |= 1u << type;

  std::optional<vulkan::MemoryRange> range;
  if (wanted.requirements.memoryTypeBits != 0) range = of_host_.allocate(wanted);
  if (!range) return nullptr;
  if (range->memory == VK_NULL_HANDLE || range->offset % request.needs.alignment != 0 ||
      (mapped && range->mapped == nullptr)) {
    of_host_.free(*range);
    throw input_error("vulkan::MemoryCallbacks",
                      "memory for '{}' must not be null, its offset be a multiple of {}{}", request.name,
                      request.needs.alignment, mapped ? ", and it must be mapped" : "");
  }

  ++allocations_;
  return std::make_unique<Allocation>(Allocation{.memory = range->memory,
                                                 .offset = range->offset,
                                                 .bytes = request.needs.size,
                                                 .mapped = static_cast<std::byte*>(range->mapped),
                                                 .image = request.image != VK_NULL_HANDLE,
                                                 .range = *range});
}

MemoryPool::Allocation* MemoryPool::allocate(const Request& request) {
  const bool image = request.image != VK_NULL_HANDLE;
  const std::uint64_t bytes = request.needs.size;
  const std::vector<std::uint32_t> types = types_for(request.needs.memoryTypeBits, request.place);
  std::unique_ptr<Allocation> made = try_allocate(request, types);
  if (!made && release_empty()) made = try_allocate(request, types);
  if (!made) {
    const std::uint32_t heap = types.empty() ? 0 : properties_.memoryTypes[types.front()].heapIndex;
    throw device_error(
        "no device memory for '{}': needed {:.1f} MiB; the heap has {:.1f} MiB, of which this program holds "
        "{:.1f} MiB. Try smaller maps or a smaller picture",
        request.name, mib(bytes), mib(properties_.memoryHeaps[heap].size), mib(heap_used_[heap]));
  }
  Allocation* const allocation = made.get();
  live_.emplace(allocation, std::move(made));
  (image ? image_bytes_ : buffer_bytes_) += bytes;
  peak_bytes_ = std::max(peak_bytes_, image_bytes_ + buffer_bytes_);
  return allocation;
}

MemoryPool::Allocation* MemoryPool::allocate_buffer(const std::string& name, VkBuffer buffer,
                                                    BufferPlace place) {
  VkMemoryDedicatedRequirements alone{};
  alone.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS;
  VkMemoryRequirements2 needs{};
  needs.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2;
  needs.pNext = &alone;
  VkBufferMemoryRequirementsInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_REQUIREMENTS_INFO_2;
  info.buffer = buffer;
  vk_->vkGetBufferMemoryRequirements2(device_, &info, &needs);
  return allocate({.name = name,
                   .needs = needs.memoryRequirements,
                   .place = place,
                   .dedicated = alone.requiresDedicatedAllocation == VK_TRUE,
                   .buffer = buffer});
}

MemoryPool::Allocation* MemoryPool::allocate_image(const std::string& name, VkImage image) {
  VkMemoryDedicatedRequirements alone{};
  alone.sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_REQUIREMENTS;
  VkMemoryRequirements2 needs{};
  needs.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2;
  needs.pNext = &alone;
  VkImageMemoryRequirementsInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_REQUIREMENTS_INFO_2;
  info.image = image;
  vk_->vkGetImageMemoryRequirements2(device_, &info, &needs);
  const bool dedicated = alone.requiresDedicatedAllocation ||
                         (alone.prefersDedicatedAllocation && needs.memoryRequirements.size >= (1u << 20));
  return allocate({.name = name, .needs = needs.memoryRequirements, .dedicated = dedicated, .image = image});
}

void MemoryPool::free(Allocation* allocation) noexcept {
  const auto found = live_.find(allocation);
  if (!DERMIS_HOLDS(found != live_.end())) return;

  if (!allocation->block) {
    of_host_.free(allocation->range);
    (allocation->image ? image_bytes_ : buffer_bytes_) -= allocation->bytes;
    live_.erase(found);
    return;
  }

  Block& block = *allocation->block;
  try {
    block.free.give_back(allocation->offset, allocation->bytes);
  } catch (const std::bad_alloc&) {
    // The range is lost until the block is freed with the pool.
  }

  (allocation->image ? image_bytes_ : buffer_bytes_) -= allocation->bytes;
  live_.erase(found);
  if (!block.is_empty()) return;

  // Keeps one empty block per kind, for staging buffers.
  const bool another = std::ranges::any_of(blocks_, [&](const auto& other) {
    return other.get() != &block && !other->dedicated && other->type == block.type &&
           other->image == block.image && other->is_empty();
  });
  if (block.dedicated || another) release(&block);
}

bool MemoryPool::release_empty() {
  std::vector<Block*> empty;
  for (const auto& block : blocks_)
    if (block->is_empty()) empty.push_back(block.get());
  for (Block* block : empty) release(block);
  return !empty.empty();
}

void MemoryPool::release(Block* block) {
  heap_used_[properties_.memoryTypes[block->type].heapIndex] -= block->bytes;
  vk_->vkFreeMemory(device_, block->memory, nullptr);  // unmaps it
  std::erase_if(blocks_, [&](const auto& other) { return other.get() == block; });
}

}  // namespace dermis::gpu
