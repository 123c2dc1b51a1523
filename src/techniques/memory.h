// SPDX-License-Identifier: MIT
/// What a frame's maps take, summed from a plan.
#pragma once

#include <cstdint>

#include "techniques/technique.h"

namespace dermis::techniques {

/// Bytes of the maps that a technique needs once more for each further one.
struct MapMemory {
  std::uint64_t light_maps = 0;   ///< of one skin mesh of one head
  std::uint64_t shadow_maps = 0;  ///< of one head
};

/// Plans a frame of one head whose skin meshes take turns; what `settings` say of batches is not used.
MapMemory map_memory(const Technique& technique, FrameSettings settings);

}  // namespace dermis::techniques
