// SPDX-License-Identifier: MIT
/// Counts of the work that frames ask of a device, taken while they are recorded: exact, and the same on
/// every device.
#pragma once

#include <cstdint>

namespace dermis {

struct RecordedWork {
  std::uint64_t barriers = 0;        ///< calls
  std::uint64_t dispatches = 0;      ///< of compute shaders
  std::uint64_t renderings = 0;      ///< begun, of triangles into targets
  std::uint64_t draws = 0;           ///< within them
  std::uint64_t switches = 0;        ///< from rendering to compute and back
  std::uint64_t cleared_pixels = 0;  ///< of targets as a rendering begins; each target counts

  RecordedWork& operator+=(const RecordedWork& other) {
    barriers += other.barriers, dispatches += other.dispatches, renderings += other.renderings;
    draws += other.draws, switches += other.switches, cleared_pixels += other.cleared_pixels;
    return *this;
  }
};

}  // namespace dermis
