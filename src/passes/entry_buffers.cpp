// SPDX-License-Identifier: MIT
#include "passes/entry_buffers.h"

#include "frame/resources.h"

namespace dermis::passes {

EntryBuffers make_entry_buffers(FramePlan& plan, std::uint32_t parts, const gpu::TextureDesc& picture) {
  const std::uint64_t pixels = std::uint64_t{picture.width} * picture.height;
  DERMIS_ASSERT_LE(pixels, std::uint64_t{MOST_SHADED_PIXELS});
  DERMIS_ASSERT_LE(parts, std::uint32_t{MOST_PARTS});
  gpu::TextureDesc entries{.width = picture.width,
                           .height = picture.height,
                           .layers = picture.samples,
                           .format = VK_FORMAT_R32G32_UINT,
                           .array = true};
  gpu::TextureDesc samples{.width = picture.width, .height = picture.height, .format = VK_FORMAT_R32_UINT};
  const std::uint64_t list_bytes =
      parts * sizeof(io::PartRangeIo) + picture.samples * pixels * sizeof(std::uint32_t);
  return {.samples = plan.texture("samples of entries", samples),
          .entries = plan.texture("entries", entries),
          .parts = plan.buffer("parts", {.bytes = parts * sizeof(io::PartIo)}),
          .list = plan.buffer("entry list", {.bytes = list_bytes}),
          .part_count = parts,
          .width = picture.width,
          .height = picture.height};
}

void EntryBuffers::declare_shading(frame::Declare& d) const {
  d.indirect(parts);
  d.read(list);
  d.write(entries);
}

void EntryBuffers::offer_shaded(Bindings& bindings, const frame::Resources& resources) const {
  bindings.add("List", resources.buffer(list)).add("entries_of_pixels", resources.storage(entries));
}

}  // namespace dermis::passes
