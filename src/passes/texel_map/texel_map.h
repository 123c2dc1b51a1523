// SPDX-License-Identifier: MIT
/// Draws which triangle each texel of a light map shows, for passes that compute what is there.
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
    std::vector<bool> overlapping;       ///< likewise: its map is drawn in each frame
  } settings;
  struct In {
    TexelMaps maps;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

/// Draws those. Where triangles overlap in the unwrap, only what the frame lights of each is drawn: one that
/// nobody sees does not take the texels of one that is seen.
class TexelMap {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    std::vector<bool> overlapping;  ///< as StaleTexels: of these meshes, what is kept
    bool clip = false;              ///< and of that what lies in the picture and its margin
  } settings;
  struct In {
    TexelMaps maps;
    KeptTriangles kept = {};  ///< as Irradiance; needed if any mesh overlaps
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  const gpu::Pipeline *whole_ = nullptr, *overlapping_ = nullptr;
};

}  // namespace dermis::passes
