// SPDX-License-Identifier: MIT
/// Writes what each pixel shows: one sample at its middle, of the opaque and cut-out parts of all visible
/// instances.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "frame/graph.h"
#include "render/passes/frame_data.h"
#include "render/passes/pixels/labels/labels_io.h"

namespace dermis::passes {

/// Words of each label in a pixel, in the order of its bit: labels_io.h.
inline constexpr std::array<std::uint32_t, LABEL_COUNT> label_words{3, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1};
static_assert(std::accumulate(label_words.begin(), label_words.end(), 0u) == LABEL_MOST_WORDS + 2);

class Labels {
 public:
  static constexpr std::size_t most_targets = 4;  ///< every device draws to so many at once
  struct Settings {
    std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
    std::uint32_t labels =
        0;  ///< LABEL_... bits of those that are drawn, at least one, none of LABEL_FRONT_LAYER
    bool keeps_depth = false;  ///< Out::depth is read
  } settings;
  struct In {
  } in;
  struct Out {
    /// RGBA32UI, four words of a pixel each; labels_io.h has their order. Those that are drawn come first.
    std::array<frame::TextureId, most_targets> words;
    frame::TextureId depth;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  /// Returns whether these labels are found once for each asset, at its vertices: nose, ears, parts,
  /// thickness.
  static bool needs_body(std::uint32_t labels) {
    return (labels & (LABEL_REGION | LABEL_THICKNESS | LABEL_PART | LABEL_FRONT_LAYER)) != 0;
  }
  /// Needs Head::before and, of needs_body(), label_vertices of every skin mesh and page of surfaces.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void draw_skin(gpu::Cmd& cmd, const FrameData& frame, const Head& head) const;
  void draw_surfaces(gpu::Cmd& cmd, const FrameData& frame, const Head& head) const;
  const gpu::Pipeline* pipeline_of(const GpuMaterial& material, bool skin) const;

  std::size_t targets() const;

  Out out_;
  const gpu::Pipeline* pipelines_[2][2][2] = {};  // [skin][double sided][cut out]
};

/// Binds what labels.vert reads of a part that is no skin, and its material.
void bind_label_surface(gpu::Cmd& cmd, const gpu::Pipeline& pipeline, const FrameData& frame,
                        const Head& head, std::uint32_t page, const GpuMaterial& material, bool body);

}  // namespace dermis::passes
