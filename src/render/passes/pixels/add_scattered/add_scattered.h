// SPDX-License-Identifier: MIT
/// Adds light that was blurred in screen space to the entries of each pixel. To the rest, which ShadeSplit
/// left there, comes the blurred light times the share that leaves the skin.
#pragma once

#include "render/passes/compute_pass.h"
#include "render/passes/pixels/entry_buffers.h"

namespace dermis::passes {

class AddScattered : public ComputePass {
 public:
  struct Settings {
  } settings;
  struct In {
    frame::TextureId blurred;  ///< as ScreenSurface::light
    frame::TextureId leaving;  ///< of ScreenSurface
    EntryBuffers entries;      ///< shaded
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
