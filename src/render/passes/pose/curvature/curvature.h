// SPDX-License-Identifier: MIT
/// Finds the curvature of a skin mesh at its vertices: once, and again when it is moved by a pose.
/// Based on: NVIDIA: FaceWorks, 2014 (the mean of the least and the most that edges have, smoothed along
/// edges)
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
