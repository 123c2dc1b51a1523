// SPDX-License-Identifier: MIT
/// Spreads light that was blurred at half the width and height over the pixels of the picture: each takes
/// that of the pixels around it that show the same skin, at its depth.
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/screen_surface.h"

namespace dermis::passes {

class RestoreSkin : public ComputePass {
 public:
  struct Settings {
    std::vector<float>
        mm_per_unit;  ///< mm of the asset per metre of the world, one per skin mesh of the plan
  } settings;
  struct In {
    frame::TextureId blurred;  ///< as `halved`.light
    ScreenSurface halved;      ///< of HalveSkin
    ScreenSurface surface;
  } in;
  struct Out {
    frame::TextureId light;  ///< as ScreenSurface::light
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  gpu::Buffer scales_;
  Out out_;
};

}  // namespace dermis::passes
