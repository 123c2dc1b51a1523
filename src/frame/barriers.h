// SPDX-License-Identifier: MIT
// Derives barriers from consecutive uses. Pure data: tested without a device.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/graph.h"

namespace dermis::frame {

struct Barrier {
  bool is_texture = true;
  std::uint32_t index = 0;
  VkPipelineStageFlags2 source_stages = 0, target_stages = 0;
  VkAccessFlags2 source_access = 0, target_access = 0;
  VkImageLayout old_layout = VK_IMAGE_LAYOUT_UNDEFINED, new_layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool first_use = false;  ///< first use in the frame: its source is the last use of the previous frame
};

/// Returns the barriers before each pass, at as few passes as will do: those of a pass stand earlier, beside
/// others, where no pass in between touches what they are for. The graph repeats frame after frame on one
/// queue, so the first use of a resource waits for its last use in the previous frame. Transient contents are
/// discarded (old layout undefined), unless the texture stays in GENERAL. Such and persistent ones keep their
/// layout: the recorder replaces the old layout of a first use by the current layout of the texture,
/// undefined in the first frame. The lists of passes that a frame of this kind does not have are empty.
std::vector<std::vector<Barrier>> derive_barriers(const FrameGraph& graph,
                                                  const FrameKind& kind = whole_frame);

/// Returns the layout in which the last pass that uses a texture leaves it; undefined if none does.
VkImageLayout final_layout(const FrameGraph& graph, TextureId id, const FrameKind& kind = whole_frame);

}  // namespace dermis::frame
