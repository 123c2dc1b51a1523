// SPDX-License-Identifier: MIT
/// Technique::report and Technique::gutters: what a frame has computed, and the seams that it reads.
#pragma once

#include <span>
#include <vector>

#include "render/techniques/screen.h"

namespace dermis::techniques::papers {

/// Slots of FrameOutputs::counters.
enum Counter : std::uint32_t {
  counter_unshaded_reads = screen_counters,
  counter_missed_light,
  counter_objects  ///< the first of ObjectCounter, which stand here for each skin mesh of each head
};
enum ObjectCounter : std::uint32_t { counter_lit_texels, counter_masked_texels, counters_of_object };

inline std::uint32_t object_counter(const FrameSettings& settings, std::uint32_t head,
                                    std::uint32_t mesh_in_model, ObjectCounter which) {
  return counter_objects + counters_of_object * (settings.most_meshes() * head + mesh_in_model) + which;
}
inline std::size_t counter_count(const FrameSettings& settings) {
  return counter_objects + std::size_t{counters_of_object} * settings.most_meshes() * settings.head_count();
}

/// Mask by which convolutions skip unlit texels: there are some if anything is culled or clipped.
enum class Mask : std::uint8_t { none, alpha, depth };
Mask mask_of(const FrameSettings& settings);

FrameReport report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                   std::span<const passes::Head> heads);
std::vector<GutterSize> gutters(const FrameSettings& settings, std::span<const passes::Head> heads);

}  // namespace dermis::techniques::papers
