// SPDX-License-Identifier: MIT
#include "render/passes/light_map/gutters/gutters.h"

#include "frame/resources.h"
#include "render/passes/asset/gutter_list.h"
#include "render/passes/bindings.h"
#include "render/shared/gutters_io.h"

namespace dermis::passes {

Gutters::Out Gutters::declare(frame::Declare& d) {
  compute(d, "gutters.comp");
  d.runs(settings.runs);
  d.write(in.target);
  return {in.target};
}

void Gutters::refresh(gpu::Cmd& cmd, const frame::Resources& resources, const GpuMesh& mesh,
                      glm::uvec2 origin, std::uint32_t side) const {
  const auto found = mesh.gutters.find(side);
  if (found == mesh.gutters.end() || found->second.count == 0) return;
  Bindings()
      .add("Gutters", found->second.list)
      .add("target", resources.storage(in.target))
      .bind(cmd, pipeline());
  const io::GuttersIo io{.count = found->second.count,
                         .mode = settings.what == What::stretch ? 1u : 0u,
                         .origin = origin,
                         .side = side};
  dispatch(cmd, io, gutter_invocations(io.count));
}

void Gutters::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const auto mesh_of = [&](const MapSquare& square) -> const GpuMesh& {
    return head_of(frame, square).asset->skin[mesh_in_asset(frame, square)];
  };

  if (settings.what != What::stretch) {
    for (const UsedSquare& square : blurred_squares(frame, settings.squares, settings.step))
      refresh(cmd, resources, mesh_of(square), square.origin, square.side);
    return;
  }

  for (const MapSquare& square : settings.squares)
    if (!settings.when_moved || head_of(frame, square).moves)
      refresh(cmd, resources, mesh_of(square), {0, 0}, resources.texture(in.target).desc().width);
}

}  // namespace dermis::passes
