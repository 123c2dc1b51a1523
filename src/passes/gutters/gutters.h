// SPDX-License-Identifier: MIT
/// Refreshes the texels beside texture seams from the other side (scene/gutters.h makes the list).
#pragma once

#include "frame/plan.h"
#include "passes/frame_data.h"

namespace dermis::passes {

class Gutters {
 public:
  enum class What : std::uint8_t { light, stretch };
  struct Settings {
    std::uint32_t mesh = 0;
    What what = What::light;
  };
  struct In {
    frame::TextureId target;  ///< RGBA16F, T x T, changed in place
  };
  struct Out {
    frame::TextureId target;
  };
  explicit Gutters(const Settings& settings) : settings_(settings) {}
  Out declare(frame::Declare& d, const In& in);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const;

 private:
  Settings settings_;
  In in_;
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
