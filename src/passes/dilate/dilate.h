// SPDX-License-Identifier: MIT
/// Extends the light by a few texels to unlit parts of its chart, so that bilinear reads at visible points
/// find light on all sides.
#pragma once

#include "passes/compute_pass.h"
#include "passes/light_pool.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

class Dilate : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  } settings;
  struct In {
    frame::TextureId light;    ///< RGBA16F pool, changed in place
    frame::TextureId stretch;  ///< holds the chart of each texel
    TileLists lists;           ///< tiles with unlit texels beside lit tiles
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
