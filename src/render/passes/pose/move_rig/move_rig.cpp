// SPDX-License-Identifier: MIT
#include "render/passes/pose/move_rig/move_rig.h"

#include <algorithm>

#include "render/passes/bindings.h"
#include "render/passes/pose/move_rig/move_rig_io.h"

namespace dermis::passes {
namespace {

void dispatch(gpu::Cmd& cmd, const gpu::Pipeline& pipeline, std::uint32_t vertices, float mm_per_unit) {
  for (std::uint32_t first = 0; first < vertices; first += gpu::most_in_row) {
    const std::uint32_t count = std::min(vertices - first, gpu::most_in_row);
    cmd.push(pipeline, io::MoveRigIo{.first = first, .count = count, .mm_per_unit = mm_per_unit});
    cmd.dispatch_over(pipeline, count, 1);
  }
}

}  // namespace

MoveRig::Out MoveRig::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  return {};
}

void MoveRig::prepare(gpu::PipelineLibrary& library) {
  vertices_ = &library.compute("move_rig.comp");
  metric_ = &library.compute("rig_metric.comp");
  curvature_ = &library.compute("rig_curvature.comp");
}

void MoveRig::record_vertices(gpu::Cmd& cmd, const RigMove& move) const {
  for (std::size_t i = 0; i < move.shape->vertices.size(); ++i) {
    const GpuRig::Part& part = move.asset->rig->parts[i];
    Bindings()
        .add("Vertices", move.shape->vertices[i])
        .add("Before", move.shape->before_m[i])
        .add("RigVertices", part.vertices)
        .add("Influences", part.influences)
        .add("MorphDeltas", part.deltas)
        .add("Matrices", move.matrices)
        .add("Weights", move.weights)
        .bind(cmd, *vertices_);
    dispatch(cmd, *vertices_, part.count, 0);
  }
}

void MoveRig::record_metric(gpu::Cmd& cmd, const RigMove& move) const {
  for (std::size_t i = 0; i < move.shape->skin_vertices.size(); ++i) {
    Bindings()
        .add("Vertices", move.shape->vertices[i])
        .add("SkinVertices", move.shape->skin_vertices[i])
        .add("Indices", move.asset->skin[i].indices)
        .add("MetricTriangles", move.asset->rig->skin[i].metric_triangles)
        .add("AtRest", move.asset->skin[i].skin_vertices)
        .bind(cmd, *metric_);
    dispatch(cmd, *metric_, move.asset->rig->parts[i].count, move.asset->mm_per_unit);
  }
}

// Only of skin that knows its shape.
void MoveRig::record_curvature(gpu::Cmd& cmd, const RigMove& move) const {
  for (std::size_t i = 0; i < move.shape->skin_vertices.size(); ++i) {
    const GpuRig::Skin& skin = move.asset->rig->skin[i];
    if (!skin.curvature_first) continue;
    Bindings()
        .add("Vertices", move.shape->vertices[i])
        .add("SkinVertices", move.shape->skin_vertices[i])
        .add("First", skin.curvature_first)
        .add("Neighbours", skin.curvature_neighbours)
        .bind(cmd, *curvature_);
    dispatch(cmd, *curvature_, move.asset->rig->parts[i].count, move.asset->mm_per_unit);
  }
}

// The buffers are none of the plan's: what reads them in the frame before and in this one waits here.
void MoveRig::record(gpu::Cmd& cmd, const frame::Resources&, const FrameData& frame) const {
  if (frame.moves.empty()) return;
  cmd.barrier_all();
  for (const RigMove& move : frame.moves) record_vertices(cmd, move);
  cmd.barrier_all();
  for (const RigMove& move : frame.moves) record_metric(cmd, move);
  cmd.barrier_all();
  for (const RigMove& move : frame.moves) record_curvature(cmd, move);
  cmd.barrier_all();
}

}  // namespace dermis::passes
