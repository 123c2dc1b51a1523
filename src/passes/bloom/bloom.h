// SPDX-License-Identifier: MIT
/// Spreads light as the optics of cameras and eyes do: mixes the picture with itself, filtered with
/// (1 - r/d)^4. The filter is two Gaussians, which blur smaller pictures: half the size, and a wide one on as
/// small as holds it.
/// Based on: [DLE07] GPU Gems 3, ch. 14.3.4: for d = 1, 0.0174 G(0.008) + 0.192 G(0.0576), total 0.2094
#pragma once

#include "frame/graph.h"
#include "passes/bloom/bloom_io.h"
#include "passes/compute_pass.h"
#include "passes/frame_data.h"

namespace dermis::passes {

/// One step; add_bloom() strings them together.
class BloomStep : public ComputePass {
 public:
  enum class Mode : std::uint32_t {
    downsample = BLOOM_DOWNSAMPLE,
    blur_x = BLOOM_BLUR_X,
    blur_y = BLOOM_BLUR_Y,
    combine = BLOOM_COMBINE
  };
  struct Settings {
    Mode mode = Mode::downsample;
    float sigma = 1;             ///< blur_x, blur_y: pixels of the picture that is blurred
    float share = 0;             ///< of In::smaller in the result, 0..1
    std::uint32_t halvings = 0;  ///< from the result to In::smaller
  } settings;
  struct In {
    frame::TextureId picture;
    frame::TextureId smaller = {};  ///< valid if there is a share of it
  } in;
  struct Out {
    frame::TextureId picture;
  };
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  frame::TextureId target_;
};

/// Adds bloom to `picture` and returns the result, of the same size. Spreads `amount`, 0..1, of the light;
/// the filter's radius d is a twelfth of the picture's height.
frame::TextureId add_bloom(FramePlan& plan, frame::TextureId picture, float amount);

}  // namespace dermis::passes
