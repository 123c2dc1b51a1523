// SPDX-License-Identifier: MIT
#include "passes/texel_map/texel_map.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/posed.h"

namespace dermis::passes {

frame::TextureId make_texel_map(frame::FrameGraph& graph, gpu::TextureDesc light) {
  light.format = VK_FORMAT_R32_UINT;
  return graph.texture("texel map", light, frame::Lifetime::persistent);
}

TexelMap::Out TexelMap::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  if (in.kept.valid()) d.read(in.kept.indices);
  d.colour(in.map);
  return {};
}

void TexelMap::prepare(gpu::PipelineLibrary& library) {
  const auto make = [&](const char* vertex) {
    return &library.graphics({.vertex = vertex,
                              .fragment = "texel_map.frag",
                              .constants = {},
                              .colour_formats = {VK_FORMAT_R32_UINT}});
  };
  whole_ = make("texel_map.vert");
  if (in.kept.valid()) overlapping_ = settings.clip ? make("texel_map_clipped.vert") : whole_;
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
    const auto indices = instance.scene->skin[number].indices.desc().bytes / sizeof(std::uint32_t);
    const bool overlapping = settings.overlapping[square.mesh];
    Bindings bindings;
    bindings.add("Frame", frame.frame_io).add("Head", instance.io);
    offer_mesh(instance, number, bindings);
    if (overlapping) bindings.add("Indices", kept_in(in.kept, resources, square));

    cmd.begin_rendering_area(std::span(&target, 1), {}, square.area(), true);
    bindings.bind(cmd, overlapping ? *overlapping_ : *whole_);
    cmd.draw(3 + static_cast<std::uint32_t>(indices));
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
