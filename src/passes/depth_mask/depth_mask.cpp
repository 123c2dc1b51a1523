// SPDX-License-Identifier: MIT
#include "passes/depth_mask/depth_mask.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/targets.h"

namespace dermis::passes {

DepthMask::Out DepthMask::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.read(in.light);
  d.depth(in.mask);
  return {};
}

void DepthMask::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.graphics({.vertex = "square.vert",
                                 .fragment = "depth_mask.frag",
                                 .depth_format = depth_format,
                                 .depth_test = true,
                                 .depth_write = true,
                                 .depth_compare = VK_COMPARE_OP_ALWAYS});
}

void DepthMask::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings().add("light", resources.storage(in.light)).bind(cmd, *pipeline_);
  const gpu::DepthTarget depth{.texture = &resources.texture(in.mask), .clear = 0.0f};
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    cmd.begin_rendering_area({}, depth, square.area(), true);
    cmd.draw(3);
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
