// SPDX-License-Identifier: MIT
#include "passes/add_transmitted/add_transmitted.h"

#include "frame/resources.h"
#include "passes/add_transmitted/add_transmitted_io.h"
#include "passes/bindings.h"

namespace dermis::passes {

AddTransmitted::Out AddTransmitted::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.sample(in.light);
  d.write(in.through);
  return {in.through};
}

void AddTransmitted::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("add_transmitted.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void AddTransmitted::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", resources.sampled(in_.light, sampler_))
      .add("through", gpu::StorageImageBinding{&resources.texture(in_.through)})
      .bind(cmd, *pipeline_);
  for (const MapSquare& square : settings_.squares) {
    if (!instance_of(frame, square).visible) continue;
    const std::uint32_t side = side_of(frame, square);
    cmd.push(*pipeline_, io::AddTransmittedIo{.origin = square.origin, .side = side});
    cmd.dispatch_over(*pipeline_, side, side);
  }
}

}  // namespace dermis::passes
