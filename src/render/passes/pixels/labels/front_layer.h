// SPDX-License-Identifier: MIT
/// Draws blended parts (lashes, brows) before what the labels show: what they cover, or which of them is
/// nearest.
#pragma once

#include <cstdint>

#include "frame/graph.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class FrontLayer {
 public:
  enum class Shows : std::uint8_t {
    coverage,  ///< R16F: 1 less the product of what parts let through, 0 to 1
    part       ///< R32UI, LABEL_PART_...: of the nearest one that covers a half or more; 0: none
  };
  struct Settings {
    std::uint32_t width = 0, height = 0;  ///< of the picture, pixels
    Shows shows = Shows::coverage;
  } settings;
  struct In {
    frame::TextureId depth;  ///< Labels::Out; of Shows::part, is lost
  } in;
  struct Out {
    frame::TextureId layer;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  /// Needs label_vertices of every page of surfaces for Shows::part.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  bool shows_part() const { return settings.shows == Shows::part; }

  Out out_;
  const gpu::Pipeline* pipelines_[2] = {};  // [double sided]
};

}  // namespace dermis::passes
