// SPDX-License-Identifier: MIT
#include "render/techniques/published/cull.h"

#include <algorithm>

#include "frame/resources.h"
#include "render/passes/asset/offer.h"

namespace dermis::techniques::papers {

io::CullIo cull_io(const passes::Head& head, const passes::GpuMaterial& material) {
  return {.can_cull = material.double_sided ? 0u : 1u, .side = static_cast<float>(head.detail.side)};
}

Cull::Out Cull::declare(frame::Declare& d) {
  compute(d, "published/cull.comp");
  d.write(in.kept);
  return {};
}

void Cull::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  if (!is_lit(frame, settings.object)) return;
  const passes::Head& head = head_of(frame, settings.object);
  passes::Bindings bindings;
  bindings.add("Frame", frame.frame_io).add("Head", head.io).add("Kept", resources.buffer(in.kept));
  passes::offer_mesh(head, mesh_in_asset(frame, settings.object), bindings);
  bindings.bind(cmd, pipeline());

  for (const passes::GpuDraw& draw : mesh_of(frame, settings.object).draws) {
    const io::CullIo cull = cull_io(head, head.look->material(draw.material));
    const std::uint32_t end = (draw.first_index + draw.index_count) / 3;
    for (std::uint32_t first = draw.first_index / 3; first < end; first += gpu::most_in_row) {
      const std::uint32_t count = std::min(end - first, gpu::most_in_row);
      dispatch(cmd, io::CullTrianglesIo{.cull = cull, .first = first, .count = count}, count, 1);
    }
  }
}

}  // namespace dermis::techniques::papers
