// SPDX-License-Identifier: MIT
/// Tone map: converts linear radiance to display values of 8 bits, with its bloom and a colour behind the
/// heads.
#pragma once

#include "dermis/settings.h"
#include "frame/graph.h"
#include "render/passes/compute_pass.h"
#include "render/passes/finish/spread_light.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class ToneMap : public ComputePass {
 public:
  struct Settings {
    dermis::ToneMap tone_map = dermis::ToneMap::natural;
    glm::vec3 behind_srgb{0};  ///< with `open`: a colour of the display, which no tone map changes
    float bloom = 0;           ///< 0..1, the share of the light that spreads
    Bloom spread = {};         ///< with `bloom`
    bool display = true;       ///< else `light` alone is written
  } settings;
  struct In {
    frame::TextureId picture;    ///< RGBA16F, one sample
    frame::TextureId open = {};  ///< of OpenShare; not valid: no colour stands behind
  } in;
  struct Out {
    frame::TextureId light;    ///< as that of In, alpha too, with what has spread and the colour
    frame::TextureId display;  ///< RGBA8, copied from afterwards; one unread texel without `display`
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool blooms() const { return settings.bloom > 0; }
  Out out_;
};

}  // namespace dermis::passes
