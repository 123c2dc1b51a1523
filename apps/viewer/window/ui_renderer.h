// SPDX-License-Identifier: MIT
/// Draws ImGui's lists, and the pictures that they name. (ImGui's own Vulkan backend of the packages shows no
/// picture but that of its font.)
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/window/swapchain.h"

struct ImDrawData;

namespace dermis::viewer {

/// Places for pictures that lists can show: ImGui's texture of one is texture_id().
enum class PictureSlot : std::uint32_t { font, a, b, map };
inline constexpr std::size_t picture_slots = 4;

inline void* texture_id(PictureSlot slot) {
  return reinterpret_cast<void*>(static_cast<std::uintptr_t>(slot) + 1);
}

class UiRenderer {
 public:
  UiRenderer(const PresentDevice& device, VkFormat target);
  UiRenderer(const UiRenderer&) = delete;
  UiRenderer& operator=(const UiRenderer&) = delete;

  /// Takes a picture, four values per pixel, rows from top to bottom; shown from the next record() on.
  void set_picture(PictureSlot slot, int width, int height, std::span<const std::uint8_t> rgba);

  /// Records uploads and lists of one frame, over a ground of the given colour. Of the device, no frame may
  /// be on its way.
  void record(const Swapchain::Frame& frame, const ImDrawData& lists, const std::array<float, 4>& ground);

 private:
  struct Slot {
    DeviceImage image;
    HostBuffer staging;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<std::uint8_t> waiting;  ///< to be uploaded
    VkExtent2D extent{};
  };
  void make_layouts();
  void upload(VkCommandBuffer commands, Slot& slot);
  void copy_vertices(const ImDrawData& lists);
  void draw(VkCommandBuffer commands, VkExtent2D extent, const ImDrawData& lists) const;

  const PresentDevice& device_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkDescriptorPool> pool_;
  Owned<VkPipeline> pipeline_;
  std::array<Slot, picture_slots> slots_;
  HostBuffer vertices_, indices_;
};

}  // namespace dermis::viewer
