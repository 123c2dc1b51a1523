// SPDX-License-Identifier: MIT
/// Heads drawn in their texture coordinates: the light that enters the skin, per texel.
/// Based on: [DLE07] sec. 3.2; [BL03] Borshukov, Lewis: Realistic Human Face Rendering for "The Matrix Reloaded", 2003; what is not shaded:
/// [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3 (cull), 4 (the used square), 5 (clip).
#pragma once

#include "passes/light_pool.h"
#include "passes/lighting.h"

namespace dermis::passes {

class Irradiance {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    bool cull = false;  ///< leave out triangles that face away from the eye; see shared/seen.glsl
    bool clip = false;  ///< leave out what lies outside FrameData::clip_planes
  };
  struct In {
    frame::TextureId light;   ///< RGBA16F pool; the used squares are cleared here
    frame::TextureId shadow;  ///< of these instances
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
