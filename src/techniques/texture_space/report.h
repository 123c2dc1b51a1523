// SPDX-License-Identifier: MIT
/// What a frame in texture space has computed, and the gutters that it reads: see Technique.
#pragma once

#include <span>
#include <vector>

#include "techniques/technique.h"

namespace dermis::techniques {

FrameReport texture_space_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                                 std::span<const std::uint32_t> sides);
std::vector<GutterSize> texture_space_gutters(const FrameSettings& settings,
                                              std::span<const std::uint32_t> sides);

}  // namespace dermis::techniques
