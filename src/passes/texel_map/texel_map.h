// SPDX-License-Identifier: MIT
/// Draws which triangle each texel of a light map shows, for passes that compute what is there. Where
/// triangles overlap in the unwrap, only those that the frame keeps are drawn, so that one which nobody sees
/// does not take the texels of one that is seen.
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/kept_triangles.h"
#include "passes/light_pool.h"
#include "passes/texel_maps.h"

namespace dermis::passes {

/// Finds the squares whose texel map is of another T, of another unwrap, or of other triangles.
class StaleTexels : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::vector<std::uint32_t> unwraps;  ///< number of the unwrap, by skin mesh of the plan
    std::vector<bool> every_frame;       ///< likewise: it is drawn in each frame; empty: none
  } settings;
  struct In {
    TexelMaps maps;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Draws those.
class TexelMap {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::vector<bool> every_frame;  ///< as StaleTexels: of these meshes, what is kept
  } settings;
  struct In {
    TexelMaps maps;
    KeptTriangles kept = {};  ///< as Irradiance; needed if any mesh is drawn in each frame
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline* pipeline_ = nullptr;
};

}  // namespace dermis::passes
