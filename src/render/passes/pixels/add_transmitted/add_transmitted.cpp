// SPDX-License-Identifier: MIT
#include "render/passes/pixels/add_transmitted/add_transmitted.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/pixels/add_transmitted/add_transmitted_io.h"

namespace dermis::passes {

AddTransmitted::Out AddTransmitted::declare(frame::Declare& d) {
  compute(d, "add_transmitted.comp");
  d.sample(in.light);
  d.sample(in.start);
  d.write(in.through);
  return {in.through};
}

void AddTransmitted::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  frame::TextureId bound;
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const frame::TextureId light =
        terms_of(frame, square).first_step < settings.next_step ? in.light : in.start;
    if (light != bound)
      Bindings()
          .add("light", resources.nearest(light))
          .add("through", resources.storage(in.through))
          .bind(cmd, pipeline());
    bound = light;
    const io::AddTransmittedIo io{.origin = square.origin, .side = square.side};
    dispatch(cmd, io, square.side, square.side);
  }
}

}  // namespace dermis::passes
