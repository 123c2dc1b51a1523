// SPDX-License-Identifier: MIT
/// Adds light that was blurred in screen space to the entries of each pixel: the rest, which ShadeSplit left
/// there, plus the blurred light times what of it leaves the skin.
#pragma once

#include "passes/compute_pass.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class AddScattered : public ComputePass {
 public:
  struct Settings {
    std::uint32_t width = 0;  ///< of the picture, pixels
  } settings;
  struct In {
    frame::TextureId blurred;         ///< as ScreenSurface::light
    frame::TextureId leaving;         ///< of ScreenSurface
    frame::BufferId pixels, entries;  ///< of passes/entries
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
