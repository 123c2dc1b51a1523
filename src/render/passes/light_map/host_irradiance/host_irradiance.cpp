// SPDX-License-Identifier: MIT
#include "render/passes/light_map/host_irradiance/host_irradiance.h"

#include "frame/resources.h"
#include "render/passes/targets.h"

namespace dermis::passes {

HostIrradiance::Out HostIrradiance::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.colour(in.map);
  return {in.map};
}

void HostIrradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& map = resources.texture(in.map);
  const std::vector<UsedSquare> squares = used_squares(frame, settings.squares);
  if (squares.empty()) return;

  for (const UsedSquare& square : squares) {
    const gpu::ColourTarget target{.texture = &map, .clear = no_light};
    cmd.begin_rendering_area(std::span(&target, 1), {}, square.area(), true);
    cmd.end_rendering();
  }
  // Clearing and drawing are two renderings, so they need a barrier.
  cmd.barrier_all();
  frame.draw_irradiance(cmd, map, squares);
}

}  // namespace dermis::passes
