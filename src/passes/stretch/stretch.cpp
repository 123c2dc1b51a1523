// SPDX-License-Identifier: MIT
#include "passes/stretch/stretch.h"

#include "frame/resources.h"

namespace dermis::passes {

Stretch::Out Stretch::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  d.runs(settings_.runs);
  in_ = in;
  d.colour(in.stretch);
  return {in.stretch};
}

void Stretch::prepare(gpu::PipelineLibrary& library) {
  for (const bool cut_out : {false, true})
    if (!cut_out || settings_.cut_out)
      pipelines_[cut_out] = &library.graphics({.vertex = "stretch.vert",
                                               .fragment = "stretch.frag",
                                               .constants = {{"cut_out", cut_out ? 1u : 0u}},
                                               .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT}});
}

void Stretch::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Texture& target = resources.texture(in_.stretch);
  const GpuMesh& mesh = frame.scene->skin[settings_.mesh];
  const gpu::ColourTarget colour{.texture = &target, .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
  cmd.begin_rendering(std::span(&colour, 1), {}, {target.desc().width, target.desc().height}, true);
  for (const GpuDraw& draw : mesh.draws) {
    const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
    Bindings bindings;
    mesh.offer(bindings);
    material.offer(bindings);
    bindings.bind(cmd, *pipelines_[material.cut_out]);
    cmd.draw(draw.index_count, 1, draw.first_index);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
