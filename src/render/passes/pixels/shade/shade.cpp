// SPDX-License-Identifier: MIT
#include "render/passes/pixels/shade/shade.h"

#include "render/passes/pixels/shade/shade_parts.h"

namespace dermis::passes {

Shade::Out Shade::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  shading_ = SkinShading(settings.look, in.lights);
  shading_.declare(d);
  in.entries.declare_shading(d);
  return {};
}

void Shade::prepare(gpu::PipelineLibrary& library) {
  for (const SkinVariant& variant : shading_.variants()) {
    const char* shader = shading_.through(variant) ? "shade_through.comp" : "shade.comp";
    pipelines_[variant.index()] = &library.compute(shader, shading_.constants(variant));
  }
  shading_.prepare(library);
}

void Shade::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  shade_parts(cmd, resources, frame, {settings.look.square, settings.first_part}, in.entries, shading_,
              pipelines_);
}

}  // namespace dermis::passes
