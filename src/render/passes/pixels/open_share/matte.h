// SPDX-License-Identifier: MIT
/// Writes how much of each pixel heads cover, as the caller of a session reads it: 32-bit floats, without
/// padding.
#pragma once

#include <cstdint>

#include "render/passes/compute_pass.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class Matte : public ComputePass {
 public:
  struct Settings {
    std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
  } settings;
  struct In {
    frame::TextureId open;  ///< OpenShare::Out
  } in;
  struct Out {
    frame::BufferId floats;  ///< one per pixel, rows from top to bottom; 0 (open) to 1
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Out out_;
};

}  // namespace dermis::passes
