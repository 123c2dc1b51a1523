// SPDX-License-Identifier: MIT
#include "passes/clear_texels/clear_texels.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/clear_texels/clear_texels_io.h"

namespace dermis::passes {

ClearTexels::Out ClearTexels::declare(frame::Declare& d) {
  compute(d, "clear_texels.comp");
  for (const frame::TextureId map : in.maps) d.write(map);
  for (const frame::BufferId buffer : in.buffers) d.copy_to(buffer);
  return {};
}

void ClearTexels::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (const frame::BufferId buffer : in.buffers) cmd.fill(resources.buffer(buffer), 0);
  const std::vector<UsedSquare> squares = used_squares(frame, settings.squares);
  for (const frame::TextureId map : in.maps) {
    Bindings().add("light", resources.storage(map)).bind(cmd, pipeline());
    for (const UsedSquare& square : squares)
      dispatch(cmd, io::ClearTexelsIo{.origin = square.origin, .side = square.side}, square.side,
               square.side);
  }
}

}  // namespace dermis::passes
