// SPDX-License-Identifier: MIT
/// What of the skin a picture shows, before it is shaded: passes/entries fills them, what shades reads them.
#pragma once

#include "passes/bindings.h"
#include "passes/frame_data.h"
#include "shared/entries_io.h"

namespace dermis::passes {

/// What is known of the entries of a frame: shared/entries_io.h.
struct EntryBuffers {
  frame::TextureId samples;  ///< R32_UINT: of the entries of each pixel, and the part of the first
  frame::TextureId entries;  ///< RG32_UINT, a layer per entry of a pixel: shaded_entry.glsl
  frame::BufferId parts;     ///< PartIo[]
  frame::BufferId list;      ///< PartRangeIo[], one per part, and then a word per entry
  std::uint32_t part_count = 0;
  std::uint32_t width = 0, height = 0;  ///< of the picture, pixels

  /// For passes that shade the entries of a part: listed_entry.glsl.
  void declare_shading(frame::Declare& d) const;
  void offer_shaded(Bindings& bindings, const frame::Resources& resources) const;
};

/// Makes the buffers for a picture of at most MOST_SHADED_PIXELS.
EntryBuffers make_entry_buffers(FramePlan& plan, std::uint32_t parts, const gpu::TextureDesc& picture);

}  // namespace dermis::passes
