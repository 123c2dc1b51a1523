// SPDX-License-Identifier: MIT
// Reads a plan and a list of barriers as a device would and says what may go wrong. Nothing here is taken
// from src/frame/barriers.cpp but the struct Barrier: what an access means, and what a barrier achieves, is
// stated anew after the Vulkan specification, so that a mistake there is not believed here.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "frame/barriers.h"

namespace dermis::frame::test {

/// One stage is one bit; shader stages of a raster pass are two.
struct Demand {
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0;                         ///< all that must see earlier writes
  VkAccessFlags2 written = 0;                        ///< the part of it that writes; 0 = only reads
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  ///< of a texture
};
Demand demand_of(Access access, PassKind kind, bool is_texture);

/// Returns whether no attachment, copy or later frame needs a layout of the texture: it stays in GENERAL.
bool only_shaders(const TextureNode& texture);

/// The kinds of frames that differ in what they have.
inline constexpr std::array frame_kinds{FrameKind{}, FrameKind{.changed = true},
                                        FrameKind{.statistics = true}, FrameKind{.first = true}, whole_frame};
std::string name_of(const FrameKind& kind);

/// Runs the plan twice on one queue, from undefined images on, without waiting in between. Each line names
/// frame, pass and resource. Found: uses that are not ordered, writes that are not made available or visible,
/// wrong layouts, contents lost, and barriers that the specification forbids or after which no pass touches
/// the resource.
std::vector<std::string> hazards(const FrameGraph& plan, const std::vector<std::vector<Barrier>>& barriers,
                                 const FrameKind& kind = whole_frame);

}  // namespace dermis::frame::test
