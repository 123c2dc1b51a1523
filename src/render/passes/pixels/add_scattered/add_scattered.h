// SPDX-License-Identifier: MIT
/// Adds light that was blurred in screen space to the entries of each pixel, times its share that leaves the
/// skin. That is the albedo after scattering, less what the surface reflects back. All entries of a pixel
/// take the light of the first, which was blurred. Those of another head were lit without scattering.
/// ShadeSplit left the rest there.
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
