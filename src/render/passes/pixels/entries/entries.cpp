// SPDX-License-Identifier: MIT
#include "render/passes/pixels/entries/entries.h"

#include "frame/resources.h"
#include "render/passes/pixels/entries/entries_io.h"
#include "render/passes/targets.h"

namespace dermis::passes {
namespace {

// From depth to a distance along the view, by the rows of the camera's matrix. clip.w is that distance (or 1,
// if the camera is orthographic), and clip.z is linear in it.
io::EntriesIo entries_io(const EntryBuffers& buffers, const FrameData& frame) {
  const io::CameraIo& camera = frame.camera;
  const glm::mat4 rows = glm::transpose(camera.clip_from_world);
  const glm::vec3 x(rows[0]), z(rows[2]), w(rows[3]);
  const float pixel = 2 / (static_cast<float>(buffers.width) * glm::length(x));  // metres per clip.w
  io::EntriesIo io{.area = frame.with_heads.io(),
                   .offset = 0,
                   .factor = 0,
                   .orthographic = camera.orthographic,
                   .pixel = pixel,
                   .parts = buffers.part_count,
                   .band_rows = buffers.band_rows};
  if (camera.orthographic != 0) {
    io.factor = 1 / glm::length(z);
  } else {
    io.offset = glm::dot(z, w) / glm::dot(w, w);
    io.factor = (rows[2].w - io.offset * rows[3].w) / glm::length(w);
    io.pixel *= glm::length(w);
  }
  return io;
}

}  // namespace

Entries::Out Entries::declare(frame::Declare& d) {
  multisampled_ = d.desc(in.ids).samples > 1;
  compute(d, multisampled_ ? "entries.comp" : "entries_single.comp");
  d.sample(in.ids);
  if (multisampled_) d.sample(in.depth);
  d.write(in.buffers.samples);
  d.write(in.buffers.entries);
  d.write(in.buffers.parts);
  return {};
}

void Entries::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("ids", resources.nearest(in.ids))
      .add("samples_of_pixels", resources.storage(in.buffers.samples))
      .add("entries_of_pixels", resources.storage(in.buffers.entries))
      .add("Parts", resources.buffer(in.buffers.parts));
  if (multisampled_) bindings.add("depths", resources.nearest(in.depth));
  bindings.bind(cmd, pipeline());
  dispatch(cmd, entries_io(in.buffers, frame), frame.with_heads.size());
}

PartRanges::Out PartRanges::declare(frame::Declare& d) {
  compute(d, "part_ranges.comp");
  d.write(in.buffers.parts);
  for (const frame::BufferId list : in.buffers.lists) d.write(list);
  return {};
}

void PartRanges::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  for (std::uint32_t band = 0; band < in.buffers.bands(); ++band) {
    Bindings()
        .add("Parts", resources.buffer(in.buffers.parts))
        .add("List", resources.buffer(in.buffers.lists[band]))
        .bind(cmd, pipeline());
    const std::uint32_t parts = in.buffers.part_count;
    dispatch(cmd, io::PartRangesIo{.parts = parts, .first_part = band * parts}, 1, 1);
  }
}

EntryList::Out EntryList::declare(frame::Declare& d) {
  compute(d, "entry_list.comp");
  d.read(in.buffers.samples);
  d.read(in.buffers.entries);
  for (const frame::BufferId list : in.buffers.lists) d.write(list);
  return {};
}

void EntryList::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (std::uint32_t band = 0; band < in.buffers.bands(); ++band) {
    const std::uint32_t first_row = in.buffers.first_row(band);
    const PixelArea area = rows_of(frame.with_heads, first_row, first_row + in.buffers.band_rows);
    if (area.low.y == area.high.y) continue;
    Bindings()
        .add("samples_of_pixels", resources.storage(in.buffers.samples))
        .add("entries_of_pixels", resources.storage(in.buffers.entries))
        .add("List", resources.buffer(in.buffers.lists[band]))
        .bind(cmd, pipeline());
    dispatch(cmd, io::EntryListIo{.area = area.io(), .width = in.buffers.width, .first_row = first_row},
             area.size());
  }
}

ResolveEntries::Out ResolveEntries::declare(frame::Declare& d) {
  const std::string shader = !in.layer.valid()      ? "resolve_entries.comp"
                             : settings.samples > 1 ? "resolve_entries_layer.comp"
                                                    : "resolve_entries_layer_single.comp";
  compute(d, shader, {{"sample_count", settings.samples}});
  out_.picture = d.create("picture", {.width = in.buffers.width,
                                      .height = in.buffers.height,
                                      .format = light_format,
                                      .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
  d.read(in.buffers.samples);
  d.read(in.buffers.entries);
  if (in.layer.valid()) d.sample(in.layer);
  d.write(out_.picture);
  return out_;
}

void ResolveEntries::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  beside_ = &library.compute("beside_heads.comp", {});
}

void ResolveEntries::empty(gpu::Cmd& cmd, const gpu::StorageImageBinding& picture, glm::uvec2 low,
                           glm::uvec2 high) const {
  if (low.x == high.x || low.y == high.y) return;
  Bindings().add("picture", picture).bind(cmd, *beside_);
  cmd.push(*beside_, PixelArea{low, high}.io());
  cmd.dispatch_over(*beside_, high.x - low.x, high.y - low.y);
}

void ResolveEntries::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings bindings;
  bindings.add("samples_of_pixels", resources.storage(in.buffers.samples))
      .add("entries_of_pixels", resources.storage(in.buffers.entries))
      .add("picture", resources.storage(out_.picture));
  if (in.layer.valid()) bindings.add("layer", resources.nearest(in.layer));
  bindings.bind(cmd, pipeline());
  dispatch(cmd, frame.with_heads.io(), frame.with_heads.size());

  const glm::uvec2 low = frame.with_heads.low, high = frame.with_heads.high,
                   end(in.buffers.width, in.buffers.height);
  const gpu::StorageImageBinding picture = resources.storage(out_.picture);
  empty(cmd, picture, {0, 0}, {end.x, low.y});
  empty(cmd, picture, {0, low.y}, {low.x, high.y});
  empty(cmd, picture, {high.x, low.y}, {end.x, high.y});
  empty(cmd, picture, {0, high.y}, end);
}

}  // namespace dermis::passes
