// SPDX-License-Identifier: MIT
#include "passes/tiles/tiles.h"

#include <cstddef>

#include "frame/resources.h"
#include "passes/bindings.h"
#include "shared/tiles_io.h"

namespace dermis::passes {
namespace {

io::TilesIo tiles_io(const FrameData& frame, const MapSquare& square, const TileLists& lists) {
  const std::uint32_t side = side_of(frame, square);
  return {.origin = square.origin,
          .side = side,
          .square = square.index,
          .first_tile = square.index * lists.room,
          .tile_count = tile_room(side),
          .border = 0,
          .slot = 0};
}

// One invocation a tile.
void dispatch(gpu::Cmd& cmd, const gpu::Pipeline& pipeline, const io::TilesIo& io) {
  cmd.push(pipeline, io);
  cmd.dispatch_over(pipeline, (io.side + TILE_WIDTH - 1) / TILE_WIDTH,
                    (io.side + TILE_HEIGHT - 1) / TILE_HEIGHT);
}

}  // namespace

ClearTiles::Out ClearTiles::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::copy);
  in_ = in;
  d.copy_to(in.lists.counts);
  d.copy_to(in.lists.arguments);
  return {};
}

void ClearTiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  cmd.fill(resources.buffer(in_.lists.counts), 0);
  cmd.fill(resources.buffer(in_.lists.arguments), 0);
}

TileClasses::Out TileClasses::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.sample(in.light);
  d.write(in.lists.classes);
  return {};
}

void TileClasses::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.compute("tile_classes.comp");
  sampler_ = library.sampler({.filter = gpu::Filter::nearest});
}

void TileClasses::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("light", resources.sampled(in_.light, sampler_))
      .add("TileClasses", resources.buffer(in_.lists.classes))
      .bind(cmd, *pipeline_);
  for (const MapSquare& square : settings_.squares)
    if (instance_of(frame, square).visible) dispatch(cmd, *pipeline_, tiles_io(frame, square, in_.lists));
}

Tiles::Out Tiles::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.read(in.lists.classes);
  d.write(in.lists.tiles);
  d.write(in.lists.counts);
  d.write(in.lists.arguments);
  d.write(in.counters);
  return {};
}

void Tiles::prepare(gpu::PipelineLibrary& library) { pipeline_ = &library.compute("tiles.comp"); }

void Tiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("TileClasses", resources.buffer(in_.lists.classes))
      .add("Tiles", resources.buffer(in_.lists.tiles))
      .add("TileCounts", resources.buffer(in_.lists.counts))
      .add("TileArguments", resources.buffer(in_.lists.arguments))
      .add("Counters", resources.buffer(in_.counters))
      .bind(cmd, *pipeline_);
  for (const MapSquare& square : settings_.squares) {
    if (!instance_of(frame, square).visible) continue;
    io::TilesIo io = tiles_io(frame, square, in_.lists);
    io.border = settings_.what == What::border ? 1 : 0;
    io.slot = settings_.first_slot + settings_.slot_stride * square.mesh;
    dispatch(cmd, *pipeline_, io);
  }
}

IdleTiles::Out IdleTiles::declare(frame::Declare& d, const In& in) {
  d.kind(frame::PassKind::compute);
  in_ = in;
  d.read(in.lists.tiles);
  d.read(in.lists.counts);
  d.indirect(in.lists.arguments);
  for (const frame::TextureId map : in.maps) d.write(map);
  return {};
}

void IdleTiles::prepare(gpu::PipelineLibrary& library) { pipeline_ = &library.compute("idle_tiles.comp"); }

void IdleTiles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const gpu::Buffer& arguments = resources.buffer(in_.lists.arguments);

  for (const frame::TextureId map : in_.maps) {
    Bindings()
        .add("Tiles", resources.buffer(in_.lists.tiles))
        .add("TileCounts", resources.buffer(in_.lists.counts))
        .add("light", gpu::StorageImageBinding{&resources.texture(map)})
        .bind(cmd, *pipeline_);

    for (const MapSquare& square : settings_.squares) {
      if (!instance_of(frame, square).visible) continue;
      const std::uint32_t side = side_of(frame, square), first = square.index * in_.lists.room;
      cmd.push(*pipeline_, io::IdleIo{.origin = square.origin,
                                      .side = side,
                                      .square = square.index,
                                      .last_tile = first + tile_room(side) - 1});
      cmd.dispatch_indirect(
          arguments, square.index * sizeof(io::TileArgumentsIo) + offsetof(io::TileArgumentsIo, idle_groups));
    }
  }
}

}  // namespace dermis::passes
