// SPDX-License-Identifier: MIT
#include "render/passes/pose/deform/deform.h"

#include "render/passes/bindings.h"
#include "render/passes/pose/deform/deform_io.h"

namespace dermis::passes {
namespace {

// The most that Vulkan lets a device ask for.
constexpr std::uint64_t alignment = 256;

std::uint32_t first_float(const DeformStream& stream) {
  return static_cast<std::uint32_t>(stream.offset % alignment / 4);
}

}  // namespace

void Deform::record(gpu::Cmd& cmd, const gpu::Buffer& vertices, const gpu::Buffer& sources,
                    std::uint32_t count, const DeformStreams& streams) const {
  if (count == 0) return;
  // Streams that are not given are not read, but must be bound.
  const auto binding = [&](const DeformStream& stream) {
    if (!stream.buffer) return gpu::BufferBinding{&sources};
    const std::uint64_t before = stream.offset % alignment;
    return gpu::BufferBinding{stream.buffer, stream.offset - before, before + stream.bytes};
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
                                    .tangent_stride = stride(streams.tangents),
                                    .first_position = first_float(streams.positions_m),
                                    .first_normal = first_float(streams.normals),
                                    .first_tangent = first_float(streams.tangents)});
  cmd.dispatch_over(*pipeline_, count, 1);
}

}  // namespace dermis::passes
