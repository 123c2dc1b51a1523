// SPDX-License-Identifier: MIT
#include "render/techniques/published/stretch.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::techniques::papers {

Stretch::Out Stretch::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::once);
  d.colour(in.stretch);
  return {};
}

void Stretch::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.graphics({.vertex = "published/stretch.vert",
                                 .fragment = "published/stretch.frag",
                                 .colour_formats = {passes::light_format}});
}

void Stretch::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& target = resources.texture(in.stretch);
  const gpu::ColourTarget colour{.texture = &target, .clear = passes::no_light};
  cmd.begin_rendering(std::span(&colour, 1), {}, {target.desc().width, target.desc().height}, true);
  passes::draw_skin(cmd, head_of(frame, settings.object), mesh_in_asset(frame, settings.object), {},
                    [&](const passes::GpuDraw&, const passes::GpuMaterial&) { return pipeline_; });
  cmd.end_rendering();
}

}  // namespace dermis::techniques::papers
