// SPDX-License-Identifier: MIT
#include "render/passes/pixels/add_scattered/add_scattered.h"

#include "frame/resources.h"

namespace dermis::passes {

AddScattered::Out AddScattered::declare(frame::Declare& d) {
  compute(d, "add_scattered.comp");
  d.sample(in.blurred);
  d.sample(in.leaving);
  d.read(in.entries.samples);
  d.write(in.entries.entries);
  return {};
}

void AddScattered::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("samples_of_pixels", resources.storage(in.entries.samples))
      .add("entries_of_pixels", resources.storage(in.entries.entries))
      .add("blurred", resources.nearest(in.blurred))
      .add("leaving_skin", resources.nearest(in.leaving))
      .bind(cmd, pipeline());
  dispatch(cmd, frame.with_heads.io(), frame.with_heads.size());
}

}  // namespace dermis::passes
