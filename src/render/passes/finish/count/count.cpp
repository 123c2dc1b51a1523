// SPDX-License-Identifier: MIT
#include "render/passes/finish/count/count.h"

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/finish/count/count_io.h"

namespace dermis::passes {

Count::Out Count::declare(frame::Declare& d) {
  compute(d, "count.comp");
  d.runs(frame::Runs::for_statistics);
  d.sample(in.picture);
  d.write(in.counters);
  return {};
}

void Count::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& picture = resources.texture(in.picture);
  Bindings()
      .add("picture", resources.nearest(in.picture))
      .add("Counters", resources.buffer(in.counters))
      .bind(cmd, pipeline());
  const auto count = [&](glm::uvec2 origin, glm::uvec2 extent, std::uint32_t slot) {
    const io::CountIo io{.origin = origin, .extent = extent, .slot = slot, .threshold = settings.threshold};
    dispatch(cmd, io, extent.x, extent.y);
  };
  if (settings.squares.empty()) count({0, 0}, {picture.desc().width, picture.desc().height}, settings.slot);
  for (const UsedSquare& square : used_squares(frame, settings.squares))
    count(square.origin, glm::uvec2(square.side), settings.slot + square.head * settings.slots_per_head);
}

}  // namespace dermis::passes
