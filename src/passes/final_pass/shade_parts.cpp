// SPDX-License-Identifier: MIT
#include "passes/final_pass/shade_parts.h"

#include "frame/resources.h"
#include "passes/draw_skin.h"
#include "passes/final_pass/shade_io.h"

namespace dermis::passes {

void shade_parts(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                 const ShadedMesh& shaded, const EntryBuffers& entries, const SkinShading& shading,
                 std::span<const gpu::Pipeline* const> pipelines, Bindings bindings) {
  const Instance& instance = instance_of(frame, shaded.square);
  if (!instance.is_drawn()) return;

  const std::uint32_t mesh = mesh_in_asset(frame, shaded.square);
  shading.offer(bindings, resources, frame);
  entries.offer_shaded(bindings, resources);

  io::ShadeIo io{.look = shading.io(frame), .width = entries.width};
  io.look.slot = shaded.first_part;
  for (const GpuDraw& draw : instance.scene->skin[mesh].draws) {
    const GpuMaterial& material = instance.look->material(draw.material);
    const gpu::Pipeline& pipeline = *pipelines[shading.variant_of(frame, draw, material).index()];
    Bindings all = bindings;
    offer_skin(all, instance, mesh, material);
    all.bind(cmd, pipeline);
    cmd.push(pipeline, io);
    cmd.dispatch_indirect(resources.buffer(entries.parts), io.look.slot * sizeof(io::PartIo));
    ++io.look.slot;
  }
}

}  // namespace dermis::passes
