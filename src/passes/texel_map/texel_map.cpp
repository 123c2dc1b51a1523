// SPDX-License-Identifier: MIT
#include "passes/texel_map/texel_map.h"

#include <algorithm>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/cull.h"
#include "passes/posed.h"

namespace dermis::passes {

frame::TextureId make_texel_map(frame::FrameGraph& graph, gpu::TextureDesc light) {
  light.format = VK_FORMAT_R32_UINT;
  return graph.texture("texel map", light, frame::Lifetime::persistent);
}

TexelMap::Out TexelMap::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.colour(in.map);
  return {};
}

void TexelMap::prepare(gpu::PipelineLibrary& library) {
  gpu::GraphicsDesc desc{.vertex = "texel_map.vert",
                         .fragment = "texel_map.frag",
                         .constants = {},
                         .colour_formats = {VK_FORMAT_R32_UINT}};
  whole_ = &library.graphics(desc);
  if (std::ranges::find(settings.overlapping, true) == settings.overlapping.end()) return;
  desc.vertex = "texel_map_seen.vert";
  desc.constants = {{"cull", settings.cull ? 1u : 0u}, {"clip", settings.clip ? 1u : 0u}};
  seen_ = &library.graphics(desc);
}

bool TexelMap::must_draw(const FrameData& frame, const UsedSquare& square) const {
  if (!frame.kept_texels) return true;
  const std::uint64_t unwrap = settings.unwraps[square.mesh] + 1, version = unwrap << 32 | square.side;
  return frame.kept_texels->must_draw(in.map, square.index, 1,
                                      settings.overlapping[square.mesh] ? 0 : version);
}

void TexelMap::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::ColourTarget target{.texture = &resources.texture(in.map)};
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    if (!must_draw(frame, square)) continue;
    const Instance& instance = instance_of(frame, square);
    const std::uint32_t number = mesh_in_asset(frame, square);
    const GpuMesh& mesh = instance.scene->skin[number];
    Bindings bindings;
    bindings.add("Frame", frame.frame_io).add("Head", instance.io);
    offer_mesh(instance, number, bindings);

    cmd.begin_rendering_area(std::span(&target, 1), {}, square.area(), true);
    bindings.bind(cmd, *whole_);
    cmd.draw(3 + static_cast<std::uint32_t>(mesh.indices.desc().bytes / sizeof(std::uint32_t)));
    if (settings.overlapping[square.mesh]) {
      bindings.bind(cmd, *seen_);
      for (const GpuDraw& draw : mesh.draws) {
        cmd.push(*seen_, cull_io(instance, instance.look->material(draw.material)));
        cmd.draw(draw.index_count, 1, 3 + draw.first_index);
      }
    }
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
