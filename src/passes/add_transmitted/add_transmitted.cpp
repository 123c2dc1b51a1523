// SPDX-License-Identifier: MIT
#include "passes/add_transmitted/add_transmitted.h"

#include "frame/resources.h"
#include "passes/add_transmitted/add_transmitted_io.h"
#include "passes/bindings.h"

namespace dermis::passes {

AddTransmitted::Out AddTransmitted::declare(frame::Declare& d) {
  compute(d, "add_transmitted.comp");
  d.sample(in.light);
  d.write(in.through);
  return {in.through};
}

void AddTransmitted::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", resources.nearest(in.light))
      .add("through", resources.storage(in.through))
      .bind(cmd, pipeline());
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const io::AddTransmittedIo io{.origin = square.origin, .side = square.side};
    dispatch(cmd, io, square.side, square.side);
  }
}

}  // namespace dermis::passes
