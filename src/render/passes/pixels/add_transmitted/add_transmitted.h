// SPDX-License-Identifier: MIT
/// Adds the transmitted light of a group of terms to the light blurred so far, before the first Gaussian that
/// includes it is blurred. So the blurs that run anyway blur it, for any number of lights. See
/// render/passes/light_map/transmission.h. Departs from [DLE07], which reads the blurred maps at the lit
/// point: docs/techniques.md says why.
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class AddTransmitted : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::uint32_t next_step = 0;  ///< of the chain of blurs
  } settings;
  struct In {
    frame::TextureId light;  ///< RGBA16F pool: blurred so far
    frame::TextureId start;  ///< the same for heads that have not been blurred before `next_step`
    /// RGBA16F pool: transmitted light; changed in place to the sum where there is light, with its alpha
    frame::TextureId through;
  } in;
  struct Out {
    frame::TextureId light;  ///< the sum
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
