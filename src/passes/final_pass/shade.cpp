// SPDX-License-Identifier: MIT
#include "passes/final_pass/shade.h"

#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/final_pass/shade_io.h"

namespace dermis::passes {

Shade::Out Shade::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  shading_ = SkinShading(settings.look, in.lights);
  shading_.declare(d);
  in.entries.declare_shading(d);
  return {};
}

void Shade::prepare(gpu::PipelineLibrary& library) {
  for (const SkinVariant& variant : shading_.variants()) {
    gpu::Constants constants = shading_.constants(variant);
    constants.emplace_back("multisampled", settings.samples > 1 ? 1u : 0u);
    pipelines_[variant.index()] =
        &library.compute(shading_.through(variant) ? "shade_through.comp" : "shade.comp", constants);
  }
  shading_.prepare(library);
}

void Shade::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const MapSquare& square = settings.look.square;
  const Instance& instance = instance_of(frame, square);
  if (!instance.is_drawn()) return;

  const std::uint32_t mesh = mesh_in_asset(frame, square);
  Bindings bindings;
  shading_.offer(bindings, resources, frame);
  in.entries.offer_shaded(bindings, resources);

  io::ShadeIo io{.look = shading_.io(frame), .extent = settings.extent};
  io.look.slot = settings.first_part;
  for (const GpuDraw& draw : instance.scene->skin[mesh].draws) {
    const GpuMaterial& material = instance.look->material(draw.material);
    const gpu::Pipeline& pipeline = *pipelines_[shading_.variant_of(instance, draw, material).index()];
    Bindings all = bindings;
    offer_skin(all, instance, mesh, material);
    all.bind(cmd, pipeline);
    cmd.push(pipeline, io);
    cmd.dispatch_indirect(resources.buffer(in.entries.parts), io.look.slot * sizeof(io::PartIo));
    ++io.look.slot;
  }
}

}  // namespace dermis::passes
