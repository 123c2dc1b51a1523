// SPDX-License-Identifier: MIT
#include "render/techniques/published/visibility.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"
#include "render/passes/targets.h"
#include "render/techniques/published/cull.h"

namespace dermis::techniques::papers {

Visibility::Out Visibility::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::when_changed);
  d.colour(in.picture);
  return {};
}

void Visibility::prepare(gpu::PipelineLibrary& library) {
  for (const bool cut_out : {false, true})
    if (!cut_out || settings.cut_out)
      pipelines_[cut_out] = &library.graphics({.vertex = "published/visibility.vert",
                                               .fragment = "published/visibility.frag",
                                               .constants = {{"cull", settings.cull ? 1u : 0u},
                                                             {"clip", settings.clip ? 1u : 0u},
                                                             {"cut_out", cut_out ? 1u : 0u}},
                                               .colour_formats = {passes::light_format}});
}

void Visibility::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const passes::Head& head = head_of(frame, settings.object);
  const std::uint32_t mesh = mesh_in_asset(frame, settings.object);
  passes::Bindings bindings;
  bindings.add("Frame", frame.frame_io);

  const gpu::ColourTarget colour{.texture = &resources.texture(in.picture), .clear = passes::no_light};
  const std::uint32_t side = used_side(frame, settings.object);
  cmd.begin_rendering(std::span(&colour, 1), {}, {side, side}, true);
  passes::draw_skin(
      cmd, head, mesh, bindings,
      [&](const passes::GpuDraw&, const passes::GpuMaterial& material) {
        return pipelines_[material.cut_out];
      },
      [&](const passes::GpuDraw&, const passes::GpuMaterial& material) { return cull_io(head, material); },
      passes::first_corners(head, mesh));
  cmd.end_rendering();
}

}  // namespace dermis::techniques::papers
