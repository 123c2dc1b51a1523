// SPDX-License-Identifier: MIT
#include "passes/depth_mask/depth_mask.h"

#include "frame/resources.h"
#include "passes/bindings.h"

namespace dermis::passes {

DepthMask::Out DepthMask::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.sample(in.light);
  d.depth(in.mask);
  return {};
}

void DepthMask::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.graphics({.vertex = "square.vert",
                                 .fragment = "depth_mask.frag",
                                 .depth_format = VK_FORMAT_D32_SFLOAT,
                                 .depth_test = true,
                                 .depth_write = true,
                                 .depth_compare = VK_COMPARE_OP_ALWAYS});
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void DepthMask::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings().add("light", resources.sampled(in_.light, sampler_)).bind(cmd, *pipeline_);
  const gpu::DepthTarget depth{.texture = &resources.texture(in_.mask), .clear = 0.0f};
  for (const MapSquare& square : settings_.squares) {
    if (!instance_of(frame, square).visible) continue;
    cmd.begin_rendering_area({}, depth, used_area(frame, square), true);
    cmd.draw(3);
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
