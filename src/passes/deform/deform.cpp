// SPDX-License-Identifier: MIT
#include "passes/deform/deform.h"

#include "passes/bindings.h"
#include "passes/deform/deform_io.h"

namespace dermis::passes {

void Deform::record(gpu::Cmd& cmd, const gpu::Buffer& vertices, const gpu::Buffer& sources,
                    std::uint32_t count, const DeformStreams& streams) const {
  if (count == 0) return;
  // What is not given is not read, but must be bound.
  const auto binding = [&](const DeformStream& stream) {
    return stream.buffer ? gpu::BufferBinding{stream.buffer, stream.offset, stream.bytes}
                         : gpu::BufferBinding{&sources};
  };
  const auto stride = [](const DeformStream& stream) { return stream.buffer ? stream.stride : 0u; };

  Bindings()
      .add("Vertices", vertices)
      .add("Sources", sources)
      .add("Positions", binding(streams.positions_m))
      .add("Normals", binding(streams.normals))
      .add("Tangents", binding(streams.tangents))
      .bind(cmd, *pipeline_);
  cmd.push(*pipeline_, io::DeformIo{.count = count,
                                    .position_stride = stride(streams.positions_m),
                                    .normal_stride = stride(streams.normals),
                                    .tangent_stride = stride(streams.tangents)});
  cmd.dispatch_over(*pipeline_, count, 1);
}

}  // namespace dermis::passes
