// SPDX-License-Identifier: MIT
/// Where the skin of a head is lit and blurred: a square in a pool of textures that all heads of a batch share.
/// Based on: [JG08] sec. 4: memory is allocated once for the largest map; a smaller one uses a corner of it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "frame/plan.h"
#include "passes/frame_data.h"

namespace dermis::passes {

/// One skin mesh of one head, and the corner of its square. How much of the square is used (T x T texels) is Instance::map_side, which
/// may change from frame to frame.
struct MapSquare {
  std::uint32_t instance = 0, mesh = 0;
  glm::uvec2 origin{0};     ///< texels
  std::uint32_t index = 0;  ///< of the square in the pool
};

inline const frame::Instance& instance_of(const frame::FrameData& frame, const MapSquare& square) {
  return frame.instances[square.instance];
}

inline VkRect2D used_area(const frame::FrameData& frame, const MapSquare& square) {
  const std::uint32_t side = instance_of(frame, square).map_side;
  return {{static_cast<std::int32_t>(square.origin.x), static_cast<std::int32_t>(square.origin.y)}, {side, side}};
}

/// How a convolution runs, and which texels it skips.
enum class Mask : std::uint8_t {
  whole,  ///< computed over the whole used square
  drawn,  ///< drawn over the whole used square
  alpha,  ///< drawn; a fragment without light ends before its taps ([JG08] sec. 3)
  depth,  ///< drawn; the depth test rejects it before it starts ([JG08] sec. 3)
  tiles   ///< computed; only tiles that hold light are dispatched
};

}  // namespace dermis::passes
