// SPDX-License-Identifier: MIT
#include "passes/shade/shade.h"

#include "passes/shade/shade_parts.h"

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
    gpu::Constants constants = shading_.constants(variant);
    constants.emplace_back("multisampled", settings.samples > 1 ? 1u : 0u);
    constants.emplace_back("light_samples", settings.look.light_samples);
    pipelines_[variant.index()] =
        &library.compute(shading_.through(variant) ? "shade_through.comp" : "shade.comp", constants);
  }
  shading_.prepare(library);
}

void Shade::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  shade_parts(cmd, resources, frame, {settings.look.square, settings.first_part}, in.entries, shading_,
              pipelines_);
}

}  // namespace dermis::passes
