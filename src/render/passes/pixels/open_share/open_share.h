// SPDX-License-Identifier: MIT
/// Share of each pixel through which the background shows: the mean over its samples of what no opaque
/// surface covers, less what blended surfaces hide there. `matte.comp` writes the rest, for callers who want
/// it. Based on: Porter, Duff: Compositing Digital Images. SIGGRAPH 1984 (over)
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class OpenShare : public ComputePass {
 public:
  struct Settings {
    std::uint32_t samples = 1;  ///< of the inputs
  } settings;
  struct In {
    frame::TextureId depth;  ///< reversed, 0 where nothing is; skin and opaque surfaces
    /// Alpha: what blended surfaces hide; not valid: there are none.
    frame::TextureId layer;
  } in;
  struct Out {
    frame::TextureId open;  ///< R32F, 0 (covered) to 1; one sample
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Out out_;
};

}  // namespace dermis::passes
