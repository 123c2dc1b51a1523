// SPDX-License-Identifier: MIT
/// Moves the vertices of a skin mesh to where a host has them, once for each time that it moves them. Its
/// buffers are in the order of its own vertices, which dermis has split and joined. The metric of the unwrap
/// stays that of the shape at rest: light blurs as if the skin had not stretched.
#pragma once

#include "gpu/cmd.h"
#include "gpu/pipelines.h"

namespace dermis::passes {

/// A stream of a host, 3 floats per vertex.
struct DeformStream {
  const gpu::Buffer* buffer = nullptr;  ///< null: not given
  std::uint64_t offset = 0;             ///< bytes of the first vertex, a multiple of 4
  std::uint64_t bytes = 0;              ///< from there
  std::uint32_t stride = 0;             ///< floats
};

struct DeformStreams {
  DeformStream positions_m, normals, tangents;
};

class Deform {
 public:
  explicit Deform(gpu::PipelineLibrary& library) : pipeline_(&library.compute("deform.comp")) {}

  /// `vertices`: VertexIo[]; `sources`: SourceVertexIo[], the `count` vertices that move. The host's vertices
  /// that they name lie in the streams.
  void record(gpu::Cmd& cmd, const gpu::Buffer& vertices, const gpu::Buffer& sources, std::uint32_t count,
              const DeformStreams& streams) const;

 private:
  const gpu::Pipeline* pipeline_;
};

}  // namespace dermis::passes
