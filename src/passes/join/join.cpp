// SPDX-License-Identifier: MIT
#include "passes/join/join.h"

#include "frame/executor.h"
#include "passes/bindings.h"
#include "passes/join/join_io.h"

namespace dermis::passes {

Join::Out Join::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.sample(in.light);
  d.write(in.through);
  return {in.through};
}

void Join::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("join.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void Join::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  Bindings()
      .add("light", resources.sampled(in_.light, sampler_))
      .add("through", gpu::StorageImageBinding{&resources.texture(in_.through)})
      .bind(cmd, *pipeline_);
  for (const MapSquare& square : settings_.squares) {
    if (!instance_of(frame, square).visible) continue;
    const std::uint32_t side = side_of(frame, square);
    cmd.push(*pipeline_, io::JoinIo{.origin = square.origin, .side = side});
    cmd.dispatch_over(*pipeline_, side, side);
  }
}

}  // namespace dermis::passes
