// SPDX-License-Identifier: MIT
#include "render/passes/pixels/labels/front_planes.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/pixels/labels/front_planes_io.h"
#include "render/passes/pixels/labels/label_planes.h"

namespace dermis::passes {

FrontPlanes::Out FrontPlanes::declare(frame::Declare& d) {
  compute(d, "front_planes.comp", {{"labels", settings.labels}});
  d.sample(in.coverage);
  d.sample(in.parts);
  d.write(in.planes);
  return {in.planes};
}

void FrontPlanes::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  const std::uint64_t pixels = std::uint64_t{settings.width} * settings.height;
  const auto first_word = [&](std::uint32_t label) {
    return static_cast<std::uint32_t>(plane_offset(settings.labels, label, pixels) / 4);
  };
  Bindings()
      .add("coverage", resources.nearest(in.coverage))
      .add("parts", resources.nearest(in.parts))
      .add("Planes", resources.buffer(in.planes))
      .bind(cmd, pipeline());
  dispatch(cmd,
           io::FrontPlanesIo{.size = {settings.width, settings.height},
                             .first_coverage = first_word(LABEL_FRONT),
                             .first_part = first_word(LABEL_FRONT_PART)},
           settings.width, settings.height);
}

}  // namespace dermis::passes
