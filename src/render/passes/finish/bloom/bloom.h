// SPDX-License-Identifier: MIT
/// Light as the optics of cameras and eyes spread it: the picture, filtered with (1 - r/d)^4. The filter is
/// two Gaussians, which blur smaller pictures: half the size, and a wide one on as small as holds it. The
/// tone map mixes them with the picture. Based on: [DLE07] GPU Gems 3, ch. 14.3.4: for d = 1, 0.0174 G(0.008)
/// + 0.192 G(0.0576), total 0.2094
#pragma once

#include "frame/graph.h"
#include "render/passes/compute_pass.h"
#include "render/passes/finish/spread_light.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

/// One step; add_bloom() strings them together.
class BloomStep : public ComputePass {
 public:
  struct Settings {
    float sigma = 0;             ///< of a blur: pixels of the picture that is blurred
    std::uint32_t halvings = 0;  ///< from the picture to the target; 0: it is blurred
  } settings;
  struct In {
    frame::TextureId picture, target;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Blurs `picture`. The filter's radius d is a twelfth of the picture's height.
Bloom add_bloom(FramePlan& plan, frame::TextureId picture);

}  // namespace dermis::passes
