// SPDX-License-Identifier: MIT
/// Slots of FrameOutputs::counters: what a frame in texture space counts on the device.
#pragma once

#include <cstddef>
#include <cstdint>

#include "passes/downsample/downsample.h"
#include "techniques/screen.h"

namespace dermis::techniques {

enum Counter : std::uint32_t {
  counter_unshaded_reads = screen_counters,
  counter_transmission_misses,
  counter_meshes  ///< the first of MeshCounter, which stand here for each skin mesh and each size of its maps
};

enum MeshCounter : std::uint32_t {
  counter_lit_texels,
  counter_masked_texels,
  counter_tiles,
  counter_level_stride
};
inline constexpr std::uint32_t counter_mesh_stride = counter_level_stride * (passes::max_halvings + 1);

inline std::size_t counter_count(std::size_t skin_meshes) {
  return counter_meshes + counter_mesh_stride * skin_meshes;
}
inline std::uint32_t mesh_counter(std::uint32_t mesh, std::uint32_t halvings, MeshCounter which) {
  return counter_meshes + counter_mesh_stride * mesh + counter_level_stride * halvings + which;
}

}  // namespace dermis::techniques
