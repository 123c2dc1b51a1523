// SPDX-License-Identifier: MIT
/// Finds the triangles that no pixel can show; the light map leaves them out.
/// Based on: [JG08] sec. 3, see cull.glsl
#pragma once

#include "render/passes/compute_pass.h"
#include "render/techniques/published/cull_io.h"
#include "render/techniques/published/object.h"

namespace dermis::techniques::papers {

/// Inputs of cull.glsl, beside the camera of the frame.
io::CullIo cull_io(const passes::Head& head, const passes::GpuMaterial& material);

class Cull : public passes::ComputePass {
 public:
  struct Settings {
    Object object;
  } settings;
  struct In {
    /// uint[], as GpuMesh::indices: all triangles keep their place, those that are culled have three times
    /// the same vertex. Room for the largest mesh.
    frame::BufferId kept;
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;
};

}  // namespace dermis::techniques::papers
