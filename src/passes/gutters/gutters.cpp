// SPDX-License-Identifier: MIT
#include "passes/gutters/gutters.h"

#include "frame/executor.h"
#include "passes/bindings.h"
#include "shared/gutters_io.h"

namespace dermis::passes {

Gutters::Out Gutters::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.write(in.target);
  return {in.target};
}

void Gutters::prepare(gpu::PipelineLibrary& library) { pipeline_ = &library.compute("gutters.comp"); }

void Gutters::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  const GpuMesh& mesh = frame.scene->skin[settings_.mesh];
  if (mesh.gutter_count == 0) return;
  Bindings().add("Gutters", mesh.gutters).add("target", gpu::StorageImageBinding{&resources.texture(in_.target)}).bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::GuttersIo{.count = mesh.gutter_count, .mode = settings_.what == What::stretch ? 1u : 0u});
  cmd.dispatch_over(*pipeline_, mesh.gutter_count, 1);
}

}  // namespace dermis::passes
