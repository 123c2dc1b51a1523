// SPDX-License-Identifier: MIT
#include "passes/cull_triangles/cull_triangles.h"

#include <algorithm>

#include "passes/bindings.h"
#include "passes/cull.h"
#include "passes/cull_triangles/cull_triangles_io.h"
#include "passes/posed.h"

namespace dermis::passes {
namespace {

// Workgroups of 64 in the least number that Vulkan allows.
constexpr std::uint32_t most_at_once = 65535 * 64;

}  // namespace

CullTriangles::Out CullTriangles::declare(frame::Declare& d) {
  compute(d, "cull_triangles.comp", {{"cull", settings.cull ? 1u : 0u}, {"clip", settings.clip ? 1u : 0u}});
  d.write(in.kept.indices);
  return {};
}

void CullTriangles::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const Instance& instance = instance_of(frame, square);
    const std::uint32_t number = mesh_in_asset(frame, square);
    const GpuMesh& mesh = instance.scene->skin[number];
    Bindings bindings;
    bindings.add("Frame", frame.frame_io)
        .add("Head", instance.io)
        .add("Kept", kept_in(in.kept, resources, square));
    offer_mesh(instance, number, bindings);
    bindings.bind(cmd, pipeline());

    for (const GpuDraw& draw : mesh.draws) {
      const io::CullIo cull = cull_io(instance, instance.look->material(draw.material));
      const std::uint32_t end = (draw.first_index + draw.index_count) / 3;
      for (std::uint32_t first = draw.first_index / 3; first < end; first += most_at_once) {
        const std::uint32_t count = std::min(end - first, most_at_once);
        dispatch(cmd, io::CullTrianglesIo{.cull = cull, .first = first, .count = count}, count, 1);
      }
    }
  }
}

}  // namespace dermis::passes
