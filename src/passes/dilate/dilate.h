// SPDX-License-Identifier: MIT
/// Extends the light by a few texels to where its chart goes on unlit, so that bilinear reads of visible
/// points find light on all sides.
#pragma once

#include "passes/light_pool.h"
#include "passes/tile_lists.h"

namespace dermis::passes {

class Dilate {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
  };
  struct In {
    frame::TextureId light;    ///< RGBA16F pool, changed in place
    frame::TextureId stretch;  ///< says which chart a texel belongs to
    TileLists lists;           ///< tiles with unlit texels beside lit tiles
  };
  struct Out {};
  explicit Dilate(const Settings& settings) : settings_(settings) {}
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
