// SPDX-License-Identifier: MIT
/// Makes what techniques in screen space blur at half the width and height: of each two by two pixels those
/// that show the skin mesh of one head that most of them show.
#pragma once

#include "passes/compute_pass.h"
#include "passes/screen_surface.h"

namespace dermis::passes {

class HalveSkin : public ComputePass {
 public:
  struct Settings {
  } settings;
  struct In {
    ScreenSurface surface;
  } in;
  struct Out {
    ScreenSurface surface;  ///< `leaving` has the numbers of skin meshes alone
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Out out_;
};

}  // namespace dermis::passes
