// SPDX-License-Identifier: MIT
/// Moves the vertices of instances that take poses, and finds metric and curvature of their moved skin: morph
/// targets, then the mean of the matrices that a vertex hangs on. Normals follow by the cofactors of that
/// mean, and tangents are perpendicular to them. With the moved metric a Gaussian keeps its width in
/// millimetres on a stretched cheek. Only for instances that have moved since the last frame; positions from
/// before are kept. Based on: glTF 2.0 specification, sections 3.7.2.2 (morph targets) and 3.7.3.3 (skins)
#pragma once

#include "frame/graph.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class MoveRig {
 public:
  struct Settings {
  } settings;
  struct In {
  } in;
  struct Out {};
  Out declare(frame::Declare& d);
  void prepare(gpu::PipelineLibrary& library);
  /// Records nothing if FrameData::moves is empty.
  void record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const;

 private:
  void record_vertices(gpu::Cmd& cmd, const RigMove& move) const;
  void record_metric(gpu::Cmd& cmd, const RigMove& move) const;
  void record_curvature(gpu::Cmd& cmd, const RigMove& move) const;

  const gpu::Pipeline* vertices_ = nullptr;
  const gpu::Pipeline* metric_ = nullptr;
  const gpu::Pipeline* curvature_ = nullptr;
};

}  // namespace dermis::passes
