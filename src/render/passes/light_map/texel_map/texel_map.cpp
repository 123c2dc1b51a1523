// SPDX-License-Identifier: MIT
#include "render/passes/light_map/texel_map/texel_map.h"

#include "frame/resources.h"
#include "render/passes/asset/offer.h"
#include "render/passes/bindings.h"

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
  pipeline_ = &library.graphics({.vertex = "texel_map.vert",
                                 .fragment = "texel_map.frag",
                                 .constants = {},
                                 .colour_formats = {VK_FORMAT_R32_UINT}});
}

bool TexelMap::must_draw(const FrameData& frame, const UsedSquare& square) const {
  if (!frame.kept_texels) return true;
  const std::uint64_t unwrap = settings.unwraps[square.mesh] + 1;
  return frame.kept_texels->must_draw(in.map, square.index, 1, unwrap << 32 | square.side);
}

void TexelMap::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::ColourTarget target{.texture = &resources.texture(in.map)};
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    if (!must_draw(frame, square)) continue;
    const Head& head = head_of(frame, square);
    const std::uint32_t number = mesh_in_asset(frame, square);
    const gpu::Buffer& indices = head.asset->skin[number].indices;
    Bindings bindings;
    offer_mesh(head, number, bindings);

    cmd.begin_rendering_area(std::span(&target, 1), {}, square.area(), true);
    bindings.bind(cmd, *pipeline_);
    cmd.draw(3 + static_cast<std::uint32_t>(indices.desc().bytes / sizeof(std::uint32_t)));
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
