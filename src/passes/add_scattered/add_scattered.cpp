// SPDX-License-Identifier: MIT
#include "passes/add_scattered/add_scattered.h"

#include "frame/resources.h"
#include "passes/add_scattered/add_scattered_io.h"
#include "passes/bindings.h"

namespace dermis::passes {

AddScattered::Out AddScattered::declare(frame::Declare& d) {
  compute(d, "add_scattered.comp");
  d.sample(in.blurred);
  d.sample(in.leaving);
  d.read(in.pixels);
  d.write(in.entries);
  return {};
}

void AddScattered::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Pixels", resources.buffer(in.pixels))
      .add("Entries", resources.buffer(in.entries))
      .add("blurred", resources.nearest(in.blurred))
      .add("leaving_skin", resources.nearest(in.leaving))
      .bind(cmd, pipeline());
  dispatch(cmd,
           io::AddScatteredIo{.low = frame.heads.low, .size = frame.heads.size(), .width = settings.width},
           frame.heads.size());
}

}  // namespace dermis::passes
