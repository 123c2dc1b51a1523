// SPDX-License-Identifier: MIT
#include "render/passes/light_map/tiles/tiles.h"

#include <algorithm>

#include "frame/resources.h"
#include "render/passes/asset/offer.h"
#include "render/passes/bindings.h"
#include "render/passes/light_map/tiles/tiles_io.h"
#include "render/shared/tiles_io.h"

namespace dermis::passes {
namespace {

constexpr float bilinear = 1;  // texels beside a point that a read there touches

}  // namespace

SeenTiles::Out SeenTiles::declare(frame::Declare& d) {
  compute(d, "seen_tiles.comp", {{"cull", settings.cull ? 1u : 0u}, {"clip", settings.clip ? 1u : 0u}});
  d.write(in.lists.marks);
  return {};
}

void SeenTiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Head& head = head_of(frame, square);
    const std::uint32_t number = mesh_in_asset(frame, square);
    Bindings bindings;
    bindings.add("Frame", frame.frame_io)
        .add("Head", head.io)
        .add("TileMarks", resources.buffer(in.lists.marks));
    offer_mesh(head, number, bindings);
    bindings.bind(cmd, pipeline());

    const std::vector<GpuDraw>& draws = head.asset->skin[number].draws;
    for (std::size_t k = 0; k < draws.size(); ++k) {
      io::SeenTilesIo io{
          .can_cull = head.look->material(draws[k].material).double_sided ? 0u : 1u,
          .first = draws[k].first_index / 3,
          .count = 0,
          .side = square.side,
          .first_tile = square.index * in.lists.room,
          .list = in.lists.of_material(square, k) - square.index * in.lists.lists,
          .reach = bilinear + settings.exit_offsets[square.mesh] * static_cast<float>(square.side)};
      const std::uint32_t end = (draws[k].first_index + draws[k].index_count) / 3;
      for (; io.first < end; io.first += io.count) {
        io.count = std::min(end - io.first, gpu::most_in_row);
        dispatch(cmd, io, io.count, 1);
      }
    }
  }
}

Tiles::Out Tiles::declare(frame::Declare& d) {
  compute(d, "tiles.comp");
  d.read(in.lists.marks);
  d.write(in.lists.tiles);
  d.write(in.lists.counts);
  d.write(in.lists.arguments);
  d.write(in.counters);
  for (const frame::TextureId map : in.maps) d.write(map);
  return {};
}

void Tiles::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  clear_ = &library.compute("clear_tiles.comp", {});
}

void Tiles::clear(gpu::Cmd& cmd, const frame::Resources& resources,
                  const std::vector<UsedSquare>& squares) const {
  for (const frame::TextureId map : in.maps) {
    Bindings().add("light", resources.storage(map)).bind(cmd, *clear_);
    for (const UsedSquare& square : squares) {
      cmd.push(*clear_, io::ClearTilesIo{.origin = square.origin, .side = square.side});
      cmd.dispatch_over(*clear_, square.side, square.side);
    }
  }
}

void Tiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Buffer& marks = resources.buffer(in.lists.marks);
  const std::vector<UsedSquare> squares = used_squares(frame, settings.squares);
  for (const UsedSquare& square : squares) {
    const auto& gutters = head_of(frame, square).asset->skin[mesh_in_asset(frame, square)].gutters;
    const auto found = gutters.find(square.side);
    const bool linked = found != gutters.end() && found->second.count > 0;
    Bindings()
        .add("TileMarks", marks)
        .add("Tiles", resources.buffer(in.lists.tiles))
        .add("TileCounts", resources.buffer(in.lists.counts))
        .add("TileArguments", resources.buffer(in.lists.arguments))
        .add("Counters", resources.buffer(in.counters))
        .add("TileLinks", linked ? found->second.tile_links : marks)
        .bind(cmd, pipeline());
    const io::TilesIo square_io{.side = square.side,
                                .first_tile = square.index * in.lists.room,
                                .first_list = square.index * in.lists.lists,
                                .lists = in.lists.lists,
                                .room = in.lists.room,
                                .slot = settings.first_slot + settings.slots_per_head * square.head +
                                        settings.slots_per_mesh * mesh_in_asset(frame, square),
                                .linked = linked ? 1u : 0u};
    dispatch(cmd, square_io, io::tiles_across(square.side));
  }
  clear(cmd, resources, squares);
}

}  // namespace dermis::passes
