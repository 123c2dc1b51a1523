// SPDX-License-Identifier: MIT
#include "passes/irradiance/irradiance.h"

#include "frame/executor.h"
#include "passes/seen.h"

namespace dermis::passes {

Irradiance::Out Irradiance::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.colour(in.light);
  d.sample(in.shadow);
  return {in.light};
}

void Irradiance::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.graphics({.vertex = settings_.clip ? "irradiance_clipped.vert" : "irradiance.vert",
                                 .fragment = "irradiance.frag",
                                 .constants = {{"cull", settings_.cull ? 1u : 0u}},
                                 .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT}});
  samplers_ = LightingSamplers(library);
}

void Irradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  const gpu::Texture& target = resources.texture(in_.light);
  const gpu::ColourTarget colour{.texture = &target, .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
  for (const MapSquare& square : settings_.squares) {
    const GpuMesh& mesh = frame.scene->skin[square.mesh];
    const frame::Instance& instance = instance_of(frame, square);
    if (!instance.visible) continue;
    cmd.begin_rendering_area(std::span(&colour, 1), {}, used_area(frame, square), true);
    for (const GpuDraw& draw : mesh.draws) {
      const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
      Bindings bindings;
      mesh.offer(bindings);
      material.offer(bindings);
      samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
      bindings.bind(cmd, *pipeline_);
      cmd.push(*pipeline_, seen_io(frame, instance, material));
      cmd.draw(draw.index_count, 1, draw.first_index);
    }
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
