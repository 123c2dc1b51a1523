// SPDX-License-Identifier: MIT
/// The blurred light of all terms of one skin mesh, weighted and added, for a host that shades it.
/// Based on: [DLE07] sec. 3.4
#pragma once

#include <array>
#include <vector>

#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class ScatterSum : public ComputePass {
 public:
  struct Settings {
    MapSquare square;
    std::vector<std::array<float, 3>> weights;  ///< one per term, 1 to 8
  } settings;
  struct In {
    std::vector<frame::TextureId> lights;  ///< RGBA16F pools, one per term
    /// RGBA16F array: a layer, as large as the pool, per MapPlace::batch
    frame::TextureId sum;
  } in;
  struct Out {
    frame::TextureId sum;
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Leaves a texture as shaders of the host sample it. Records nothing but what the graph does for it.
class HandOver {
 public:
  struct Settings {
  } settings;
  struct In {
    frame::TextureId texture;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd&, const frame::Resources&, const FrameData&) const {}
};

}  // namespace dermis::passes
