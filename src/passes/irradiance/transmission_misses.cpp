// SPDX-License-Identifier: MIT
#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/irradiance/irradiance.h"

namespace dermis::passes {

TransmissionMisses::Out TransmissionMisses::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.runs(frame::Runs::for_statistics);
  d.sample(in.shadow);
  if (in.kept.valid()) d.indices(in.kept.indices);
  if (in.entering.valid()) d.sample(in.entering);
  d.write(in.counters);
  return {};
}

void TransmissionMisses::prepare(gpu::PipelineLibrary& library) {
  const Irradiance::Settings& irradiance = settings.irradiance;
  gpu::GraphicsDesc desc{.vertex = irradiance.clip ? "irradiance_clipped.vert" : "irradiance.vert",
                         .fragment = "transmission_misses.frag",
                         .constants = {{"slot", settings.slot},
                                       {"entering_stored", in.entering.valid() ? 1u : 0u},
                                       {"through_terms", 0u}}};
  pipelines_.clear();
  for (const ThroughMesh& mesh : irradiance.through) {
    desc.constants.back().second = mesh.mapped_terms();
    pipelines_.push_back(&library.graphics(desc));
  }
  samplers_ = LightingSamplers(library);
  through_ = ThroughBindings(library, irradiance.through);
}

void TransmissionMisses::record(gpu::Cmd& cmd, const frame::Resources& resources,
                                const FrameData& frame) const {
  for (const UsedSquare& square : used_squares(frame, settings.irradiance.squares)) {
    const Instance& instance = instance_of(frame, square);
    const std::uint32_t mesh = mesh_in_asset(frame, square);
    const std::size_t entry = through_.entry_of(square.mesh);
    Bindings bindings;
    bindings.add("Frame", frame.frame_io);
    samplers_.offer(bindings, frame, instance, resources.texture(in.shadow));
    samplers_.offer_sky(bindings, instance, mesh);
    through_.offer(bindings, resources, in.entering, in.shadow, entry);
    bindings.add("Counters", resources.buffer(in.counters));

    cmd.begin_rendering_area({}, {}, square.area(), true);
    draw_skin(
        cmd, instance, mesh, bindings, [&](const GpuDraw&, const GpuMaterial&) { return pipelines_[entry]; },
        nullptr, in.kept.valid() ? kept_in(in.kept, resources, square) : gpu::BufferBinding{});
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
