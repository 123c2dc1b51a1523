// SPDX-License-Identifier: MIT
/// Refreshes the texels beside seams: light crosses a seam, because each texel beside it continues the skin
/// of the other chart. The list is made once per mesh and T (head/scene/surface/gutters.h). Departs from GPU
/// Gems 3, ch. 14.4.3, which fades to local light at seams.
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class Gutters : public ComputePass {
 public:
  enum class What : std::uint8_t { light, stretch };
  struct Settings {
    /// stretch: one, at the origin, of the texture's size whatever the head's T
    std::vector<MapSquare> squares;
    What what = What::light;
    frame::Runs runs = frame::Runs::every_frame;  ///< once: of a map that lasts
    /// light: leaves out heads that enter the chain of blurs after this step
    std::uint32_t step = ~0u;
    /// of a stretch map: does nothing in frames in which the head has not moved
    bool when_moved = false;
  } settings;
  struct In {
    frame::TextureId target;  ///< RGBA16F pool, changed in place
  } in;
  struct Out {
    frame::TextureId target;
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void refresh(gpu::Cmd& cmd, const frame::Resources& resources, const GpuMesh& mesh, glm::uvec2 origin,
               std::uint32_t side) const;
};

}  // namespace dermis::passes
