// SPDX-License-Identifier: MIT
// From consecutive uses to barriers. Pure data: tested without a device.
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
  bool first_use = false;  ///< of the frame: its source is the last use of the frame before
};

/// barriers[p] stand before pass p. The graph is taken as repeated frame after frame on one queue, so the
/// first use of a resource waits for its last use of the frame before (transient contents are discarded: old
/// layout undefined; persistent ones keep their layout, and whoever records replaces the old layout of a
/// first use by the one that the texture is really in: undefined in the first frame). The lists of passes
/// that a frame of this kind does not have are empty.
std::vector<std::vector<Barrier>> derive_barriers(const FrameGraph& graph,
                                                  const FrameKind& kind = whole_frame);

/// The layout in which a texture is left by the last pass that uses it; undefined if none does.
VkImageLayout final_layout(const FrameGraph& graph, TextureId id, const FrameKind& kind = whole_frame);

}  // namespace dermis::frame
