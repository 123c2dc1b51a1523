// SPDX-License-Identifier: MIT
/// Adds the light that a group of terms brings through the body to the light spread so far; see
/// passes/transmission.h.
#pragma once

#include "passes/light_pool.h"

namespace dermis::passes {

class AddTransmitted {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  };
  struct In {
    frame::TextureId light;  ///< RGBA16F pool: spread so far
    /// RGBA16F pool: what comes through; changed in place, the sum where there is light, and its alpha
    frame::TextureId through;
  };
  struct Out {
    frame::TextureId light;  ///< the sum
  };
  explicit AddTransmitted(const Settings& settings) : settings_(settings) {}
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
