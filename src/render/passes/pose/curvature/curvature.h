// SPDX-License-Identifier: MIT
/// Finds the curvature of a skin mesh at its vertices, 1/mm: once, and again when it is moved by a pose. On
/// an edge it is the turn of the normal over the length. At a vertex it is the mean of the least and the most
/// of its edges. Vertices that a seam has split count as one. Neighbours are averaged at least twice, over
/// about 1.5 mm: light that scatters sees no finer shape. Sums are of whole numbers, so every run has the
/// same bits. Based on: NVIDIA: FaceWorks, 2014, which keeps the curvature of the bind pose
#pragma once

#include <array>

#include "frame/graph.h"
#include "render/passes/light_map/light_pool.h"

namespace dermis::passes {

class Curvature {
 public:
  struct Settings {
    MapSquare square;            ///< of any head with the mesh
    std::uint32_t vertices = 0;  ///< of the mesh
    std::uint32_t triangles = 0;
    bool posed = false;  ///< it takes poses: again in each frame that moves it
  } settings;
  struct In {
    frame::BufferId
        per_mm;  ///< written: float[], 1/mm of the asset, per vertex; positive where the skin bulges
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  /// Needs GpuMesh::welded.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  std::array<const gpu::Pipeline*, 6> steps_{};
  frame::BufferId points_;
};

}  // namespace dermis::passes
