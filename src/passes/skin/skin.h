// SPDX-License-Identifier: MIT
/// The head on the screen: the weighted sum of the blurred light, albedo, two-lobe specular.
/// Based on: [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6. With no terms it is the Lambert model with the same light and energy.
#pragma once

#include <array>
#include <vector>

#include "frame/plan.h"
#include "passes/frame_data.h"
#include "passes/lighting.h"

namespace dermis::passes {

class Skin {
 public:
  struct Settings {
    std::uint32_t instance = 0, mesh = 0;
    std::uint32_t samples = 1;                  ///< of the targets
    bool clear = false;                         ///< the first to draw into them
    std::vector<std::array<float, 3>> weights;  ///< a term each, 0 to 8; none = Lambert
  };
  struct In {
    std::vector<frame::TextureId> lights;  ///< a term each
    frame::TextureId shadow, colour, depth;
  };
  struct Out {
    frame::TextureId colour, depth;
  };
  explicit Skin(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* single_sided_ = nullptr;
  const gpu::Pipeline* double_sided_ = nullptr;
  LightingSamplers samplers_;
  VkSampler light_sampler_ = VK_NULL_HANDLE;
};

}  // namespace dermis::passes
