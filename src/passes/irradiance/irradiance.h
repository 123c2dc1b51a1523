// SPDX-License-Identifier: MIT
/// The head drawn in its texture coordinates: the light that enters the skin, per texel.
/// Based on: [DLE07] sec. 3.2; [BL03] Borshukov, Lewis: Realistic Human Face Rendering for "The Matrix Reloaded", 2003.
#pragma once

#include "frame/plan.h"
#include "passes/frame_data.h"
#include "passes/lighting.h"

namespace dermis::passes {

class Irradiance {
 public:
  struct Settings {
    std::uint32_t instance = 0, mesh = 0;
  };
  struct In {
    frame::TextureId light;   ///< RGBA16F, T x T, cleared here
    frame::TextureId shadow;  ///< of this instance
  };
  struct Out {
    frame::TextureId light;
  };
  explicit Irradiance(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
  LightingSamplers samplers_;
};

}  // namespace dermis::passes
