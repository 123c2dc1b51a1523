// SPDX-License-Identifier: MIT
#include "passes/show_visibility/show_visibility.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/cull.h"

namespace dermis::passes {

ShowVisibility::Out ShowVisibility::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::when_changed);
  in_ = in;
  d.colour(in.picture);
  return {};
}

void ShowVisibility::prepare(gpu::PipelineLibrary& library) {
  for (const bool cut_out : {false, true})
    if (!cut_out || settings_.cut_out)
      pipelines_[cut_out] = &library.graphics({.vertex = "show_visibility.vert",
                                               .fragment = "show_visibility.frag",
                                               .constants = {{"cull", settings_.cull ? 1u : 0u},
                                                             {"clip", settings_.clip ? 1u : 0u},
                                                             {"cut_out", cut_out ? 1u : 0u}},
                                               .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT}});
}

void ShowVisibility::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const GpuMesh& mesh = frame.scene->skin[settings_.square.mesh];
  const Instance& instance = instance_of(frame, settings_.square);
  const gpu::ColourTarget colour{.texture = &resources.texture(in_.picture),
                                 .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
  cmd.begin_rendering(std::span(&colour, 1), {}, {instance.map_side, instance.map_side}, true);
  for (const GpuDraw& draw : mesh.draws) {
    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
    const gpu::Pipeline& pipeline = *pipelines_[material.cut_out];
    Bindings bindings;
    mesh.offer(bindings);
    material.offer(bindings);
    bindings.bind(cmd, pipeline);
    cmd.push(pipeline, cull_io(frame, instance, material));
    cmd.draw(draw.index_count, 1, draw.first_index);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
