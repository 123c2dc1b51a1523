// SPDX-License-Identifier: MIT
#include "passes/tiled_pass.h"

#include <utility>

#include "frame/resources.h"
#include "shared/tiles_io.h"

namespace dermis::passes {

void TiledPass::tiled(frame::Declare& d, std::string shader, const TileLists& lit, frame::TextureId target) {
  shader_ = std::move(shader);
  lit_ = lit;
  target_ = target;

  d.kind(frame::PassKind::compute);
  d.write(target);
  if (!lit.valid()) return;
  d.read(lit.tiles);
  d.read(lit.counts);
  d.indirect(lit.arguments);
}

void TiledPass::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute(shader_, {{"tiled", lit_.valid() ? 1u : 0u}});
}

void TiledPass::offer(Bindings& bindings, const frame::Resources& resources,
                      const gpu::Buffer& unused) const {
  bindings.add("Tiles", lit_.valid() ? resources.buffer(lit_.tiles) : unused)
      .add("TileCounts", lit_.valid() ? resources.buffer(lit_.counts) : unused)
      .add("light_out", resources.storage(target_));
}

void TiledPass::dispatch(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square) const {
  if (lit_.valid())
    cmd.dispatch_indirect(resources.buffer(lit_.arguments), square.index * sizeof(io::TileArgumentsIo));
  else
    cmd.dispatch_over(pipeline(), square.side, square.side);
}

}  // namespace dermis::passes
