// SPDX-License-Identifier: MIT
#include "passes/dilate/dilate.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/dilate/dilate_io.h"
#include "shared/tiles_io.h"

namespace dermis::passes {

Dilate::Out Dilate::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.write(in.light);
  d.sample(in.stretch);
  d.read(in.lists.tiles);
  d.read(in.lists.counts);
  d.indirect(in.lists.arguments);
  return {};
}

void Dilate::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("dilate.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void Dilate::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", gpu::StorageImageBinding{&resources.texture(in_.light)})
      .add("stretch", resources.sampled(in_.stretch, sampler_))
      .add("Tiles", resources.buffer(in_.lists.tiles))
      .add("TileCounts", resources.buffer(in_.lists.counts))
      .bind(cmd, *pipeline_);
  for (const MapSquare& square : settings_.squares) {
    if (!instance_of(frame, square).visible) continue;
    cmd.push(*pipeline_, io::DilateIo{.origin = square.origin,
                                      .side = side_of(frame, square),
                                      .square = square.index,
                                      .first_tile = square.index * in_.lists.room});
    cmd.dispatch_indirect(resources.buffer(in_.lists.arguments), square.index * sizeof(io::TileArgumentsIo));
  }
}

}  // namespace dermis::passes
