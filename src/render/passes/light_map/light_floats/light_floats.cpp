// SPDX-License-Identifier: MIT
#include "render/passes/light_map/light_floats/light_floats.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/light_map/light_floats/light_floats_io.h"

namespace dermis::passes {

LightFloats::Out LightFloats::declare(frame::Declare& d) {
  compute(d, "light_floats.comp");
  d.sample(in.picture);
  out_.floats = d.create("linear picture",
                         gpu::BufferDesc{.bytes = std::uint64_t{16} * settings.width * settings.height});
  d.write(out_.floats);
  return out_;
}

void LightFloats::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  Bindings()
      .add("picture", resources.nearest(in.picture))
      .add("Floats", resources.buffer(out_.floats))
      .bind(cmd, pipeline());
  dispatch(cmd, io::LightFloatsIo{.size = {settings.width, settings.height}}, settings.width,
           settings.height);
}

}  // namespace dermis::passes
