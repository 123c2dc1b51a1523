// SPDX-License-Identifier: MIT
/// Technique::report and Technique::gutters of texture space: what a frame has computed, and the gutters that
/// it reads.
#pragma once

#include <span>
#include <vector>

#include "render/techniques/technique.h"

namespace dermis::techniques {

FrameReport texture_space_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                                 std::span<const passes::Head> heads);
std::vector<GutterSize> texture_space_gutters(const FrameSettings& settings,
                                              std::span<const passes::Head> heads);

}  // namespace dermis::techniques
