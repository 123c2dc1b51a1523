// SPDX-License-Identifier: MIT
#include "passes/irradiance/irradiance.h"

#include "frame/executor.h"
#include "passes/irradiance/irradiance_io.h"

namespace dermis::passes {

Irradiance::Out Irradiance::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  in_ = in;
  d.colour(in.light);
  d.sample(in.shadow);
  return {in.light};
}

void Irradiance::prepare(gpu::PipelineLibrary& library) {
  pipeline_ =
      &library.graphics({.vertex = "irradiance.vert", .fragment = "irradiance.frag", .colour_formats = {VK_FORMAT_R16G16B16A16_SFLOAT}});
  samplers_ = LightingSamplers(library);
}

void Irradiance::record(gpu::Cmd& cmd, const frame::Resources& resources, const frame::FrameData& frame) const {
  const gpu::Texture& target = resources.texture(in_.light);
  const GpuMesh& mesh = frame.scene->skin[settings_.mesh];
  const frame::Instance& instance = frame.instances[settings_.instance];
  const gpu::ColourTarget colour{.texture = &target, .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}};
  cmd.begin_rendering(std::span(&colour, 1), {}, {target.desc().width, target.desc().height}, true);
  for (const GpuDraw& draw : mesh.draws) {
    Bindings bindings;
    mesh.offer(bindings);
    frame.scene->materials[static_cast<std::size_t>(draw.material)].offer(bindings);
    samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
    bindings.bind(cmd, *pipeline_);
    cmd.push(*pipeline_, io::IrradianceIo{.offset_m = instance.offset_m});
    cmd.draw(draw.index_count, 1, draw.first_index);
  }
  cmd.end_rendering();
}

}  // namespace dermis::passes
