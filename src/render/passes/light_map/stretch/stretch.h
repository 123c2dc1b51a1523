// SPDX-License-Identifier: MIT
/// The metric of the unwrap in texture space: the extent of a millimetre of skin in texture coordinates.
/// Based on: [DLE07] GPU Gems 3, ch. 14.4.2 (stretch map). It has two lengths; here it is the whole metric,
/// because real unwraps are sheared.
#pragma once

#include "frame/graph.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class Stretch {
 public:
  struct Settings {
    MapSquare square;  ///< of any head with the mesh
    /// every_frame if skin meshes take turns with the map, or take poses, else once
    frame::Runs runs = frame::Runs::once;  ///< a rigid mesh keeps its metric
    bool cut_out = false;                  ///< some of its skin is cut out, and belongs to no chart
    bool when_moved = false;               ///< does nothing in frames in which the head has not moved
  } settings;
  struct In {
    frame::TextureId
        /// RGBA16F, persistent if it is made once: (a, b, c) of the Cholesky factor per metre,
        /// chart number (0 = no skin)
        stretch;
  } in;
  struct Out {
    frame::TextureId stretch;
  };
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipelines_[2] = {};  // [cut out]
};

}  // namespace dermis::passes
