// SPDX-License-Identifier: MIT
/// Skin that a picture shows, before it is shaded: render/passes/pixels/entries fills the buffers, passes
/// that shade read them.
#pragma once

#include <vector>

#include "render/passes/bindings.h"
#include "render/passes/frame_data.h"
#include "render/shared/entries_io.h"

namespace dermis::passes {

/// The entries of a frame: render/shared/entries_io.h.
struct EntryBuffers {
  frame::TextureId samples;  ///< R32_UINT: of the entries of each pixel, and the part of the first
  frame::TextureId entries;  ///< RG32_UINT, a layer per entry of a pixel: shaded_entry.glsl
  frame::BufferId parts;     ///< PartIo[], those of one band after the other
  /// of each band of rows: PartRangeIo[], one per part, and then a word per entry
  std::vector<frame::BufferId> lists;
  std::uint32_t part_count = 0;         ///< of the frame, at most MOST_PARTS
  std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
  std::uint32_t band_rows = 0;          ///< pixels; the last band may have fewer

  std::uint32_t bands() const { return static_cast<std::uint32_t>(lists.size()); }
  std::uint32_t first_row(std::uint32_t band) const { return band * band_rows; }

  /// For passes that shade the entries of a part in a band: listed_entry.glsl.
  void declare_shading(frame::Declare& d) const;
  void offer_shaded(Bindings& bindings, const frame::Resources& resources, std::uint32_t band) const;
};

/// Makes the buffers for a picture.
EntryBuffers make_entry_buffers(FramePlan& plan, std::uint32_t parts, const gpu::TextureDesc& picture);

}  // namespace dermis::passes
