// SPDX-License-Identifier: MIT
/// Which texels hold light, as depth, so that the depth test keeps convolutions off the others.
/// Based on: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3.
#pragma once

#include "passes/light_pool.h"

namespace dermis::passes {

class DepthMask {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  };
  struct In {
    frame::TextureId light;  ///< RGBA16F pool
    frame::TextureId mask;   ///< D32 pool: 1 where the light's alpha is not 0, else 0
  };
  struct Out {};
  explicit DepthMask(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
  VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace dermis::passes
