// SPDX-License-Identifier: MIT
#include "render/passes/pixels/shade/unshaded_reads.h"

#include "frame/resources.h"
#include "render/passes/pixels/shade/shade_parts.h"

namespace dermis::passes {

UnshadedReads::Out UnshadedReads::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  d.runs(frame::Runs::for_statistics);
  settings.look.through.reset();  // maps hold it, and no other light is counted
  shading_ = SkinShading(settings.look, in.lights);
  shading_.declare(d);
  in.entries.declare_shading(d);
  d.write(in.counters);
  return {};
}

void UnshadedReads::prepare(gpu::PipelineLibrary& library) {
  for (const SkinVariant& variant : shading_.variants()) {
    if (variant.lit == SkinVariant::Lit::at_pixel) continue;
    gpu::Constants constants = shading_.constants(variant);
    constants.emplace_back("counter", settings.slot);
    pipelines_[variant.index()] = &library.compute("unshaded_reads.comp", constants);
  }
  shading_.prepare(library);
}

void UnshadedReads::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("Counters", resources.buffer(in.counters));
  shade_parts(cmd, resources, frame, {settings.look.square, settings.first_part}, in.entries, shading_,
              pipelines_, bindings);
}

}  // namespace dermis::passes
