// SPDX-License-Identifier: MIT
#include "passes/gutters/gutters.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "shared/gutters_io.h"

namespace dermis::passes {

Gutters::Out Gutters::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.runs(settings_.runs);
  d.write(in.target);
  return {in.target};
}

void Gutters::prepare(gpu::PipelineLibrary& library) { pipeline_ = &library.compute("gutters.comp"); }

void Gutters::refresh(gpu::Cmd& cmd, const gpu::Texture& target, const GpuMesh& mesh, glm::uvec2 origin,
                      std::uint32_t side) const {
  const auto found = mesh.gutters.find(side);
  if (found == mesh.gutters.end() || found->second.count == 0) return;
  Bindings()
      .add("Gutters", found->second.list)
      .add("target", gpu::StorageImageBinding{&target})
      .bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::GuttersIo{.count = found->second.count,
                                     .mode = settings_.what == What::stretch ? 1u : 0u,
                                     .origin = origin,
                                     .side = side});
  cmd.dispatch_over(*pipeline_, found->second.count, 1);
}

void Gutters::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& target = resources.texture(in_.target);
  for (const MapSquare& square : settings_.squares) {
    const GpuMesh& mesh = frame.scene->skin[square.mesh];
    if (settings_.what == What::stretch)
      refresh(cmd, target, mesh, {0, 0}, target.desc().width);
    else if (instance_of(frame, square).visible)
      refresh(cmd, target, mesh, square.origin, side_of(frame, square));
  }
}

}  // namespace dermis::passes
