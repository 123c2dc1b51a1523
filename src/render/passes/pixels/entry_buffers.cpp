// SPDX-License-Identifier: MIT
#include "render/passes/pixels/entry_buffers.h"

#include <fmt/format.h>

#include <algorithm>

#include "frame/resources.h"

namespace dermis::passes {

EntryBuffers make_entry_buffers(FramePlan& plan, std::uint32_t parts, const gpu::TextureDesc& picture) {
  DERMIS_ASSERT_LE(parts, std::uint32_t{MOST_PARTS});
  gpu::TextureDesc entries{.width = picture.width,
                           .height = picture.height,
                           .layers = picture.samples,
                           .format = VK_FORMAT_R32G32_UINT,
                           .array = true};
  gpu::TextureDesc samples{.width = picture.width, .height = picture.height, .format = VK_FORMAT_R32_UINT};

  EntryBuffers buffers{.samples = plan.texture("samples of entries", samples),
                       .entries = plan.texture("entries", entries),
                       .parts = {},
                       .lists = {},
                       .part_count = parts,
                       .width = picture.width,
                       .height = picture.height,
                       .band_rows = std::min(picture.height, MOST_BAND_PIXELS / picture.width)};
  const std::uint64_t band_pixels = std::uint64_t{picture.width} * buffers.band_rows;
  const std::uint64_t list_bytes =
      parts * sizeof(io::PartRangeIo) + picture.samples * band_pixels * sizeof(std::uint32_t);
  for (std::uint32_t row = 0; row < picture.height; row += buffers.band_rows)
    buffers.lists.push_back(
        plan.buffer(fmt::format("entry list {}", buffers.bands()), {.bytes = list_bytes}));
  buffers.parts =
      plan.buffer("parts", {.bytes = std::uint64_t{buffers.bands()} * parts * sizeof(io::PartIo)});
  return buffers;
}

void EntryBuffers::declare_shading(frame::Declare& d) const {
  d.indirect(parts);
  for (const frame::BufferId list : lists) d.read(list);
  d.write(entries);
}

void EntryBuffers::offer_shaded(Bindings& bindings, const frame::Resources& resources,
                                std::uint32_t band) const {
  bindings.add("List", resources.buffer(lists[band])).add("entries_of_pixels", resources.storage(entries));
}

}  // namespace dermis::passes
