// SPDX-License-Identifier: MIT
/// Texture-space diffusion. Based on: [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin.
/// EGSR 2007; GPU Gems 3, ch. 14.
#pragma once

#include "techniques/technique.h"

namespace dermis::techniques {

FrameOutputs build_texture_space(passes::FramePlan& plan, const FrameSettings& settings);

/// See Technique.
FrameReport report_texture_space(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                                 std::span<const std::uint32_t> sides);
std::vector<GutterSize> gutters_of_texture_space(const FrameSettings& settings,
                                                 std::span<const std::uint32_t> sides);

}  // namespace dermis::techniques
