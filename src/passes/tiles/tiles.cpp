// SPDX-License-Identifier: MIT
#include "passes/tiles/tiles.h"

#include <cstddef>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "shared/tiles_io.h"

namespace dermis::passes {
namespace {

io::TilesIo tiles_io(const UsedSquare& square, const TileLists& lists) {
  return {.origin = square.origin,
          .side = square.side,
          .square = square.index,
          .first_tile = square.index * lists.room,
          .tile_count = tile_room(square.side),
          .border = 0,
          .slot = 0};
}

// One invocation per tile.
void dispatch_tiles(gpu::Cmd& cmd, const gpu::Pipeline& pipeline, const io::TilesIo& io) {
  cmd.push(pipeline, io);
  cmd.dispatch_over(pipeline, (io.side + TILE_WIDTH - 1) / TILE_WIDTH,
                    (io.side + TILE_HEIGHT - 1) / TILE_HEIGHT);
}

}  // namespace

TileClasses::Out TileClasses::declare(frame::Declare& d) {
  compute(d, "tile_classes.comp");
  d.read(in.light);
  d.write(in.lists.classes);
  return {};
}

void TileClasses::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", resources.storage(in.light))
      .add("TileClasses", resources.buffer(in.lists.classes))
      .bind(cmd, pipeline());
  for (const UsedSquare& square : used_squares(frame, settings.squares))
    dispatch_tiles(cmd, pipeline(), tiles_io(square, in.lists));
}

Tiles::Out Tiles::declare(frame::Declare& d) {
  compute(d, "tiles.comp");
  d.read(in.lists.classes);
  d.write(in.lists.tiles);
  d.write(in.lists.counts);
  d.write(in.lists.arguments);
  d.write(in.counters);
  return {};
}

void Tiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("TileClasses", resources.buffer(in.lists.classes))
      .add("Tiles", resources.buffer(in.lists.tiles))
      .add("TileCounts", resources.buffer(in.lists.counts))
      .add("TileArguments", resources.buffer(in.lists.arguments))
      .add("Counters", resources.buffer(in.counters))
      .bind(cmd, pipeline());
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    io::TilesIo io = tiles_io(square, in.lists);
    io.border = settings.what == What::border ? 1 : 0;
    io.slot = settings.first_slot + settings.slots_per_instance * square.instance +
              settings.slots_per_mesh * mesh_in_asset(frame, square);
    dispatch_tiles(cmd, pipeline(), io);
  }
}

IdleTiles::Out IdleTiles::declare(frame::Declare& d) {
  compute(d, "idle_tiles.comp");
  d.read(in.lists.tiles);
  d.read(in.lists.counts);
  d.indirect(in.lists.arguments);
  for (const In::Map& map : in.maps) d.write(map.light);
  return {};
}

void IdleTiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Buffer& arguments = resources.buffer(in.lists.arguments);

  for (const In::Map& map : in.maps) {
    Bindings()
        .add("Tiles", resources.buffer(in.lists.tiles))
        .add("TileCounts", resources.buffer(in.lists.counts))
        .add("light", resources.storage(map.light))
        .bind(cmd, pipeline());

    for (const UsedSquare& square : used_squares(frame, settings.squares)) {
      if (terms_of(frame, square).first_written > map.term) continue;
      cmd.push(pipeline(),
               io::IdleIo{.origin = square.origin,
                          .side = square.side,
                          .square = square.index,
                          .last_tile = square.index * in.lists.room + tile_room(square.side) - 1});
      cmd.dispatch_indirect(
          arguments, square.index * sizeof(io::TileArgumentsIo) + offsetof(io::TileArgumentsIo, idle_groups));
    }
  }
}

}  // namespace dermis::passes
