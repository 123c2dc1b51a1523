// SPDX-License-Identifier: MIT
#include "frame/resources.h"
#include "passes/cull.h"
#include "passes/irradiance/irradiance.h"

namespace dermis::passes {

TransmissionMisses::Out TransmissionMisses::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::for_statistics);
  in_ = in;
  d.sample(in.shadow);
  if (in.entering.valid()) d.sample(in.entering);
  d.write(in.counters);
  return {};
}

void TransmissionMisses::prepare(gpu::PipelineLibrary& library) {
  const Irradiance::Settings& irradiance = settings_.irradiance;
  gpu::GraphicsDesc desc{.vertex = irradiance.clip ? "irradiance_clipped.vert" : "irradiance.vert",
                         .fragment = "transmission_misses.frag",
                         .constants = {{"cull", irradiance.cull ? 1u : 0u},
                                       {"slot", settings_.slot},
                                       {"entering_stored", in_.entering.valid() ? 1u : 0u},
                                       {"through_terms", 0u}}};
  pipelines_.clear();
  for (const gaussians::SumOfGaussians& profile : irradiance.through) {
    desc.constants.back().second = static_cast<std::uint32_t>(profile.terms.size());
    pipelines_.push_back(&library.graphics(desc));
  }
  samplers_ = LightingSamplers(library);
  through_ = ThroughBindings(library, irradiance.through, irradiance.mm_per_unit);
}

void TransmissionMisses::record(gpu::Cmd& cmd, const frame::Resources& resources,
                                const FrameData& frame) const {
  for (const MapSquare& square : settings_.irradiance.squares) {
    const GpuMesh& mesh = frame.scene->skin[square.mesh];
    const Instance& instance = instance_of(frame, square);
    if (!instance.visible) continue;

    cmd.begin_rendering_area({}, {}, used_area(frame, square), true);
    for (const GpuDraw& draw : mesh.draws) {
      const GpuMaterial& material = frame.scene->materials[static_cast<std::size_t>(draw.material)];
      const gpu::Pipeline& pipeline = *pipelines_[square.mesh];

      Bindings bindings;
      mesh.offer(bindings);
      material.offer(bindings);
      samplers_.offer(bindings, frame, instance, resources.texture(in_.shadow));
      samplers_.offer_sky(bindings, frame, square.mesh);
      through_.offer(bindings, resources, in_.entering, in_.shadow, square.mesh);
      bindings.add("Counters", resources.buffer(in_.counters));

      bindings.bind(cmd, pipeline);
      cmd.push(pipeline, cull_io(frame, instance, material));
      cmd.draw(draw.index_count, 1, draw.first_index);
    }
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
