// SPDX-License-Identifier: MIT
#include "render/passes/pixels/open_share/matte.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/pixels/open_share/matte_io.h"

namespace dermis::passes {

Matte::Out Matte::declare(frame::Declare& d) {
  compute(d, "matte.comp");
  d.sample(in.open);
  out_.floats =
      d.create("matte", gpu::BufferDesc{.bytes = std::uint64_t{4} * settings.width * settings.height});
  d.write(out_.floats);
  return out_;
}

void Matte::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  Bindings()
      .add("open", resources.nearest(in.open))
      .add("Matte", resources.buffer(out_.floats))
      .bind(cmd, pipeline());
  dispatch(cmd, io::MatteIo{.size = {settings.width, settings.height}}, settings.width, settings.height);
}

}  // namespace dermis::passes
