// SPDX-License-Identifier: MIT
#include "passes/masked_pass.h"

#include <optional>
#include <span>
#include <utility>

#include "frame/resources.h"
#include "passes/targets.h"
#include "shared/tiles_io.h"

namespace dermis::passes {

void MaskedPass::masked(frame::Declare& d, std::string shader, const LightMask& mask,
                        frame::TextureId target) {
  shader_ = std::move(shader);
  mask_ = mask;
  target_ = target;

  d.kind(drawn() ? frame::PassKind::raster : frame::PassKind::compute);
  if (drawn())
    d.colour(target);
  else
    d.write(target);
  if (mask.skip_unlit == SkipUnlit::by_depth) d.depth(mask.depth_mask);
  if (tiled()) {
    d.read(mask.lists.tiles);
    d.read(mask.lists.counts);
    d.indirect(mask.lists.arguments);
  }
}

void MaskedPass::prepare(gpu::PipelineLibrary& library) {
  const bool depth = mask_.skip_unlit == SkipUnlit::by_depth;
  if (drawn())
    pipeline_ =
        &library.graphics({.vertex = "square.vert",
                           .fragment = shader_ + ".frag",
                           .constants = {{"alpha_test", mask_.skip_unlit == SkipUnlit::by_alpha ? 1u : 0u}},
                           .colour_formats = {light_format},
                           .depth_format = depth ? depth_format : VK_FORMAT_UNDEFINED,
                           .depth_test = depth,
                           .depth_compare = VK_COMPARE_OP_LESS_OR_EQUAL});
  else
    pipeline_ = &library.compute(shader_ + ".comp", {{"tiled", tiled() ? 1u : 0u}});
}

void MaskedPass::offer(Bindings& bindings, const frame::Resources& resources,
                       const gpu::Buffer& unused) const {
  bindings.add("Tiles", tiled() ? resources.buffer(mask_.lists.tiles) : unused)
      .add("TileCounts", tiled() ? resources.buffer(mask_.lists.counts) : unused);
  if (!drawn()) bindings.add("light_out", resources.storage(target_));
}

void MaskedPass::run_over(gpu::Cmd& cmd, const frame::Resources& resources, const UsedSquare& square) const {
  if (drawn())
    draw(cmd, resources, square.area());
  else if (tiled())
    cmd.dispatch_indirect(resources.buffer(mask_.lists.arguments),
                          square.index * sizeof(io::TileArgumentsIo));
  else
    cmd.dispatch_over(pipeline(), square.side, square.side);
}

void MaskedPass::draw(gpu::Cmd& cmd, const frame::Resources& resources, VkRect2D area) const {
  const gpu::ColourTarget colour{.texture = &resources.texture(target_), .clear = no_light};
  std::optional<gpu::DepthTarget> depth;
  if (mask_.skip_unlit == SkipUnlit::by_depth)
    depth = gpu::DepthTarget{.texture = &resources.texture(mask_.depth_mask)};

  cmd.begin_rendering_area(std::span(&colour, 1), depth, area, true);
  cmd.draw(3);
  cmd.end_rendering();
}

}  // namespace dermis::passes
