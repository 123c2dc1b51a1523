// SPDX-License-Identifier: MIT
/// Slots of FrameOutputs::counters: what a frame in texture space counts on the device.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/techniques/screen.h"

namespace dermis::techniques {

enum Counter : std::uint32_t {
  counter_unshaded_reads = screen_counters,
  counter_transmission_misses,
  counter_squares  ///< the first of SquareCounter, which stand here for each square
};

/// Of one skin mesh of one head.
enum SquareCounter : std::uint32_t { counter_lit_texels, counter_tiles, counter_mesh_stride };

/// Returns the slots of a head.
inline std::uint32_t counter_head_stride(const FrameSettings& settings) {
  return counter_mesh_stride * settings.most_meshes();
}
inline std::size_t counter_count(const FrameSettings& settings) {
  return counter_squares + std::size_t{counter_head_stride(settings)} * settings.head_count();
}
inline std::uint32_t square_counter(const FrameSettings& settings, std::uint32_t head,
                                    std::uint32_t mesh_in_model, SquareCounter which) {
  return counter_squares + counter_head_stride(settings) * head + counter_mesh_stride * mesh_in_model + which;
}

}  // namespace dermis::techniques
