// SPDX-License-Identifier: MIT
#include "render/passes/light_map/stretch/stretch.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::passes {

Stretch::Out Stretch::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(settings.runs);
  d.colour(in.stretch);
  return {in.stretch};
}

void Stretch::prepare(gpu::PipelineLibrary& library) {
  for (const bool cut_out : {false, true})
    if (!cut_out || settings.cut_out)
      pipelines_[cut_out] = &library.graphics({.vertex = "stretch.vert",
                                               .fragment = "stretch.frag",
                                               .constants = {{"cut_out", cut_out ? 1u : 0u}},
                                               .colour_formats = {light_format}});
}

void Stretch::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (settings.when_moved && !head_of(frame, settings.square).moves) return;
  const gpu::Texture& target = resources.texture(in.stretch);
  const gpu::ColourTarget colour{.texture = &target, .clear = no_light};
  cmd.begin_rendering(std::span(&colour, 1), {}, {target.desc().width, target.desc().height}, true);
  draw_skin(cmd, head_of(frame, settings.square), mesh_in_asset(frame, settings.square), {},
            [&](const GpuDraw&, const GpuMaterial& material) { return pipelines_[material.cut_out]; });
  cmd.end_rendering();
}

}  // namespace dermis::passes
