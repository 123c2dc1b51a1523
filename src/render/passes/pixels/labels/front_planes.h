// SPDX-License-Identifier: MIT
/// Writes what FrontLayer has drawn into the planes of the labels.
#pragma once

#include <cstdint>

#include "render/passes/compute_pass.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class FrontPlanes : public ComputePass {
 public:
  struct Settings {
    std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
    std::uint32_t labels = 0;             ///< LABEL_... bits of all planes
  } settings;
  struct In {
    frame::TextureId coverage, parts;  ///< FrontLayer::Out
    frame::BufferId planes;            ///< LabelPlanes::Out, of the same labels
  } in;
  struct Out {
    frame::BufferId planes;  ///< those that came in
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
