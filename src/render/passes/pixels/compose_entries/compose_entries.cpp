// SPDX-License-Identifier: MIT
#include "render/passes/pixels/compose_entries/compose_entries.h"

#include "frame/resources.h"
#include "render/passes/pixels/compose_entries/compose_entries_io.h"

namespace dermis::passes {

ComposeEntries::Out ComposeEntries::declare(frame::Declare& d) {
  d.kind(frame::PassKind::raster);
  d.read(in.entries.samples);
  d.read(in.entries.entries);
  d.sample(in.ids);
  d.sample(in.ids_depth);
  d.colour(in.colour);
  d.depth(in.depth);
  return {};
}

void ComposeEntries::prepare(gpu::PipelineLibrary& library) {
  pipeline_ = &library.graphics(
      {.vertex = "compose_entries.vert",
       .fragment = settings.samples > 1 ? "compose_entries.frag" : "compose_entries_single.frag",
       .constants = {},
       .colour_formats = {settings.format.colour},
       .depth_format = settings.format.depth,
       .samples = settings.samples,
       .depth_test = true,
       .depth_write = true,
       .depth_compare = settings.format.nearer()});
}

void ComposeEntries::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const glm::uvec2 size = frame.with_heads.size();
  if (size.x == 0 || size.y == 0) return;

  Bindings()
      .add("samples_of_pixels", resources.storage(in.entries.samples))
      .add("entries_of_pixels", resources.storage(in.entries.entries))
      .add("ids", resources.nearest(in.ids))
      .add("depths", resources.nearest(in.ids_depth))
      .bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::ComposeEntriesIo{settings.first_part, settings.parts});

  const glm::ivec2 low(frame.with_heads.low);
  begin_picture(cmd, resources.texture(in.colour), resources.texture(in.depth), false,
                VkRect2D{{low.x, low.y}, {size.x, size.y}});
  cmd.draw(3, settings.samples);
  cmd.end_rendering();
}

}  // namespace dermis::passes
