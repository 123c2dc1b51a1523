// SPDX-License-Identifier: MIT
/// Finds the triangles of heads that no pixel can show; light maps leave them out.
/// Based on: [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3, see
///   shaders/cull.glsl
#pragma once

#include <vector>

#include "passes/compute_pass.h"
#include "passes/kept_triangles.h"
#include "passes/light_pool.h"

namespace dermis::passes {

class CullTriangles : public ComputePass {
 public:
  struct Settings {
    std::vector<MapSquare> squares;
    bool cull = true;   ///< leaves out what faces away
    bool clip = false;  ///< leaves out what lies outside the picture and its margin
  } settings;
  struct In {
    KeptTriangles kept;  ///< written for each square
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::passes
