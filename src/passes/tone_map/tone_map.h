// SPDX-License-Identifier: MIT
/// Tone map: converts linear radiance to display values of 8 bits.
#pragma once

#include "dermis/settings.h"
#include "frame/graph.h"
#include "passes/compute_pass.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class ToneMap : public ComputePass {
 public:
  struct Settings {
    dermis::ToneMap tone_map = dermis::ToneMap::natural;
    glm::vec3 behind_srgb{0};  ///< with `open`
  } settings;
  struct In {
    frame::TextureId picture;  ///< RGBA16F, one sample
    /// Of OpenShare, and the picture has the colour added: it is shown as it is. Not valid: there is none.
    frame::TextureId open;
  } in;
  struct Out {
    frame::TextureId display;  ///< RGBA8, copied from afterwards
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  frame::TextureId display_;
};

}  // namespace dermis::passes
