// SPDX-License-Identifier: MIT
#include "render/passes/light_map/show_visibility/show_visibility.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"

namespace dermis::passes {

ShowVisibility::Out ShowVisibility::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::when_changed);
  d.colour(in.picture);
  return {};
}

void ShowVisibility::prepare(gpu::PipelineLibrary& library) {
  for (const bool cut_out : {false, true})
    if (!cut_out || settings.cut_out)
      pipelines_[cut_out] = &library.graphics({.vertex = "show_visibility.vert",
                                               .fragment = "show_visibility.frag",
                                               .constants = {{"cull", settings.cull ? 1u : 0u},
                                                             {"clip", settings.clip ? 1u : 0u},
                                                             {"cut_out", cut_out ? 1u : 0u}},
                                               .colour_formats = {light_format}});
}

void ShowVisibility::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const Head& head = head_of(frame, settings.square);
  const std::uint32_t mesh = mesh_in_asset(frame, settings.square);
  Bindings bindings;
  bindings.add("Frame", frame.frame_io);

  const gpu::ColourTarget colour{.texture = &resources.texture(in.picture), .clear = no_light};
  cmd.begin_rendering(std::span(&colour, 1), {}, {head.detail.side, head.detail.side}, true);
  draw_skin(
      cmd, head, mesh, bindings,
      [&](const GpuDraw&, const GpuMaterial& material) { return pipelines_[material.cut_out]; },
      [&](const GpuDraw&, const GpuMaterial& material) { return material.double_sided ? 0u : 1u; },
      first_corners(head, mesh));
  cmd.end_rendering();
}

}  // namespace dermis::passes
