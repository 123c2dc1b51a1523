// SPDX-License-Identifier: MIT
/// Moves light to a map of half the side, by [1 3 3 1] / 8 along both axes: a level of passes/cascade/.
/// Based on: the "progressively smaller" maps that [JG08] sec. 2 mentions; passes/cascade_steps.h says when
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class Downsample : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> from, to;  ///< the same squares in the larger and in the smaller pool
  } settings;
  struct In {
    frame::TextureId light, stretch;
    frame::TextureId target;  ///< RGBA16F pool
  } in;
  struct Out {
    frame::TextureId light;
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

inline constexpr std::uint32_t max_halvings = 3;

}  // namespace dermis::passes
