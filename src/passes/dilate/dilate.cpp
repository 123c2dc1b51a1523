// SPDX-License-Identifier: MIT
#include "passes/dilate/dilate.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/dilate/dilate_io.h"
#include "shared/tiles_io.h"

namespace dermis::passes {

Dilate::Out Dilate::declare(frame::Declare& d) {
  compute(d, "dilate.comp");
  d.write(in.light);
  d.sample(in.stretch);
  d.read(in.lists.tiles);
  d.read(in.lists.counts);
  d.indirect(in.lists.arguments);
  return {};
}

void Dilate::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", resources.storage(in.light))
      .add("stretch", resources.nearest(in.stretch))
      .add("Tiles", resources.buffer(in.lists.tiles))
      .add("TileCounts", resources.buffer(in.lists.counts))
      .bind(cmd, pipeline());
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    cmd.push(pipeline(), io::DilateIo{.origin = square.origin,
                                      .side = square.side,
                                      .square = square.index,
                                      .first_tile = square.index * in.lists.room});
    cmd.dispatch_indirect(resources.buffer(in.lists.arguments), square.index * sizeof(io::TileArgumentsIo));
  }
}

}  // namespace dermis::passes
