// SPDX-License-Identifier: MIT
#include "render/passes/pose/curvature/curvature.h"

#include <algorithm>

#include "frame/resources.h"
#include "render/passes/asset/offer.h"
#include "render/passes/pose/curvature/curvature_io.h"

namespace dermis::passes {

Curvature::Out Curvature::declare(frame::Declare& d) {
  d.kind(frame::PassKind::compute);
  if (!settings.posed) d.runs(frame::Runs::once);
  const std::uint64_t vertices = std::max(settings.vertices, 1u);
  points_ = d.create("curvature points", {.bytes = vertices * sizeof(io::CurvaturePointIo)});
  d.write(points_);
  d.write(in.per_mm);
  return {};
}

void Curvature::prepare(gpu::PipelineLibrary& library) {
  for (std::uint32_t step = 0; step < steps_.size(); ++step)
    steps_[step] = &library.compute("curvature.comp", {{"step", step}});
}

void Curvature::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  const Head& head = head_of(frame, settings.square);
  if (settings.posed && !head.moves) return;
  const std::size_t number = mesh_in_asset(frame, settings.square);
  const GpuMesh::Welded& welded = head.asset->skin[number].welded;

  Bindings bindings;
  offer_mesh(head, number, bindings);
  bindings.add("WeldedPoints", welded.point_of)
      .add("CurvaturePoints", resources.buffer(points_))
      .add("Curvature", resources.buffer(in.per_mm));

  const auto run = [&](std::uint32_t step, std::uint32_t count) {
    // Rows of workgroups: one row may not have as many as a large mesh needs.
    constexpr std::uint32_t row = 64 * 1024;
    bindings.bind(cmd, *steps_[step]);
    cmd.push(*steps_[step], io::CurvatureIo{.count = count, .mm_per_unit = head.asset->mm_per_unit});
    cmd.dispatch_over(*steps_[step], std::min(count, row), (count + row - 1) / row);
    cmd.barrier_all();
  };
  run(CURVATURE_BEGIN, settings.vertices);
  run(CURVATURE_EDGES, settings.triangles);
  run(CURVATURE_MEAN, settings.vertices);
  for (int i = 0; i < welded.smoothing; ++i) {
    run(CURVATURE_SPREAD, settings.triangles);
    run(CURVATURE_SMOOTH, settings.vertices);
  }
  run(CURVATURE_FINISH, settings.vertices);
}

}  // namespace dermis::passes
