// SPDX-License-Identifier: MIT
/// Memory of the maps of a frame, summed from those that a plan has.
#pragma once

#include <cstdint>

#include "render/techniques/technique.h"

namespace dermis::techniques {

/// Bytes by which the maps of a frame grow with each further skin mesh or head.
struct MapMemory {
  std::uint64_t light_maps = 0;   ///< per skin mesh of one head
  std::uint64_t shadow_maps = 0;  ///< per head
};

/// Returns the memory, from the maps of one head whose skin meshes take turns; ignores what `settings` say of
/// batches.
MapMemory map_memory(const Technique& technique, FrameSettings settings);

}  // namespace dermis::techniques
