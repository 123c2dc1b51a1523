// SPDX-License-Identifier: MIT
/// Number of heads that are lit and blurred together, and size of the squares of their light maps. The budget
/// of memory and the texels that the heads use decide.
#pragma once

#include <cstdint>

#include "dermis/settings.h"
#include "render/techniques/technique.h"

namespace dermis::setup {

/// Properties of the device for the frame's structure.
struct DeviceTraits {
  std::uint64_t memory_bytes = 0;        ///< of the device; 0: unknown
  std::uint32_t max_image_side = 16384;  ///< texels
  std::uint32_t max_array_layers = 2048;
};

/// The heads that share the pool.
struct PoolHeads {
  std::uint32_t count = 1;
  std::uint32_t used_side = 0;  ///< texels of a side that one of them uses, at most
};

/// Sets square_side, heads_per_batch and meshes_per_batch of a plan that knows its maps and its skin.
/// Throws InputError: a budget that does not hold one square.
void set_up_pool(techniques::FrameSettings& plan, const techniques::Technique& technique,
                 const PoolHeads& heads, const RenderSettings& settings, const DeviceTraits& device);

/// Returns whether each head of a plan, which knows its heads and its pool, can have shadow maps of its own.
/// So it is where they take no more memory than those of a batch, and, with `many_frames` to come, up to 512
/// MB and a quarter of the device's memory.
bool can_keep_shadows(const techniques::FrameSettings& plan, const techniques::Technique& technique,
                      const DeviceTraits& device, bool many_frames);

}  // namespace dermis::setup
