// SPDX-License-Identifier: MIT
#include "passes/texel_map/texel_map.h"

#include "core/assert.h"
#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/posed.h"
#include "passes/texel_map/texel_map_io.h"

namespace dermis::passes {
namespace {

const GpuMesh& mesh_of(const FrameData& frame, const MapSquare& square) {
  return instance_of(frame, square).scene->skin[mesh_in_asset(frame, square)];
}

// Not 0, which is no map that lasts.
std::uint32_t stamp_of(std::uint32_t unwrap, std::uint32_t side) {
  DERMIS_ASSERT_LT(unwrap, 0xFFFFu);
  DERMIS_ASSERT_LT(side, 0x10000u);
  return (unwrap + 1) << 16 | side;
}

}  // namespace

StaleTexels::Out StaleTexels::declare(frame::Declare& d) {
  compute(d, "stale_texels.comp");
  d.write(in.maps.stamps);
  d.write(in.maps.draws);
  return {};
}

void StaleTexels::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Stamps", resources.buffer(in.maps.stamps))
      .add("Draws", resources.buffer(in.maps.draws))
      .bind(cmd, pipeline());
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const auto indices = mesh_of(frame, square).indices.desc().bytes / sizeof(std::uint32_t);
    dispatch(cmd,
             io::StaleTexelsIo{.square = square.index,
                               .stamp = settings.overlapping[square.mesh]
                                            ? 0
                                            : stamp_of(settings.unwraps[square.mesh], square.side),
                               .vertices = 3 + static_cast<std::uint32_t>(indices)},
             1, 1);
  }
}

TexelMap::Out TexelMap::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.indirect(in.maps.draws);
  if (in.kept.valid()) d.read(in.kept.indices);
  d.colour(in.maps.numbers);
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

void TexelMap::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::ColourTarget target{.texture = &resources.texture(in.maps.numbers)};
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Instance& instance = instance_of(frame, square);
    const bool overlapping = settings.overlapping[square.mesh];
    Bindings bindings;
    bindings.add("Frame", frame.frame_io).add("Head", instance.io);
    offer_mesh(instance, mesh_in_asset(frame, square), bindings);
    if (overlapping) bindings.add("Indices", kept_in(in.kept, resources, square));

    cmd.begin_rendering_area(std::span(&target, 1), {}, square.area(), true);
    bindings.bind(cmd, overlapping ? *overlapping_ : *whole_);
    cmd.draw_indirect(resources.buffer(in.maps.draws), square.index * sizeof(io::TexelDrawIo), 1);
    cmd.end_rendering();
  }
}

}  // namespace dermis::passes
