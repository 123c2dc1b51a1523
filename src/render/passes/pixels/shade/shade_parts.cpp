// SPDX-License-Identifier: MIT
#include "render/passes/pixels/shade/shade_parts.h"

#include "frame/resources.h"
#include "render/passes/draw_skin.h"

namespace dermis::passes {

void shade_parts(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                 const SkinParts& shaded, const EntryBuffers& entries, const SkinShading& shading,
                 std::span<const gpu::Pipeline* const> pipelines, Bindings bindings) {
  const Head& head = head_of(frame, shaded.square);
  if (!head.is_drawn()) return;

  const std::uint32_t mesh = mesh_in_asset(frame, shaded.square);
  shading.offer(bindings, resources, frame);

  io::ShadeIo io = shading.io(frame);
  io.width = entries.width;
  for (std::uint32_t band = 0; band < entries.bands(); ++band) {
    Bindings of_band = bindings;
    entries.offer_shaded(of_band, resources, band);
    io.first_row = entries.first_row(band);
    io.part = shaded.first_part;
    for (const GpuDraw& draw : head.asset->skin[mesh].draws) {
      const GpuMaterial& material = head.look->material(draw.material);
      const gpu::Pipeline* pipeline = pipelines[shading.variant_of(frame, draw, material).index()];
      io.first_triangle = draw.first_index / 3;
      const std::uint32_t end = io.part + draw.parts();
      if (!pipeline) {
        io.part = end;
        continue;
      }

      Bindings all = of_band;
      offer_skin(all, head, mesh, material);
      all.bind(cmd, *pipeline);
      for (; io.part < end; ++io.part, io.first_triangle += 1u << ID_TRIANGLE_BITS) {
        cmd.push(*pipeline, io);
        const std::uint32_t number = band * entries.part_count + io.part;
        cmd.dispatch_indirect(resources.buffer(entries.parts), number * sizeof(io::PartIo));
      }
    }
  }
}

}  // namespace dermis::passes
