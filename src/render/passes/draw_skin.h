// SPDX-License-Identifier: MIT
// Draws a skin mesh, with one draw per run of triangles of a material.
#pragma once

#include <cstddef>
#include <type_traits>

#include "gpu/cmd.h"
#include "render/passes/asset/offer.h"
#include "render/passes/bindings.h"

namespace dermis::passes {

/// For shaders that know their triangle: render/shaders/first_corner.glsl.
inline gpu::BufferBinding first_corners(const Head& head, std::size_t number) {
  return {&head.asset->skin[number].first_corners};
}

/// Offers a head, its skin mesh `number` and a material.
inline void offer_skin(Bindings& bindings, const Head& head, std::size_t number,
                       const GpuMaterial& material) {
  bindings.add("Head", head.io);
  offer_mesh(head, number, bindings);
  material.offer(bindings);
}

/// Draws the parts of a head's skin mesh `number`, as its asset counts them, for which
/// pipeline_of(draw, material) is not null. The shaders get `bindings`, those of head, mesh and material,
/// and io_of(draw, material) as push constants. `indices`: as many as the mesh has, at the same places; null:
/// those of the mesh.
template <class PipelineOf, class IoOf = std::nullptr_t>
void draw_skin(gpu::Cmd& cmd, const Head& head, std::size_t number, const Bindings& bindings,
               const PipelineOf& pipeline_of, const IoOf& io_of = nullptr, gpu::BufferBinding indices = {}) {
  const GpuMesh& mesh = head.asset->skin[number];
  if (!indices.buffer) indices = {&mesh.indices};
  for (const GpuDraw& draw : mesh.draws) {
    const GpuMaterial& material = head.look->material(draw.material);
    const gpu::Pipeline* pipeline = pipeline_of(draw, material);
    if (!pipeline) continue;

    Bindings all = bindings;
    offer_skin(all, head, number, material);
    all.bind(cmd, *pipeline);
    if constexpr (!std::is_null_pointer_v<IoOf>) cmd.push(*pipeline, io_of(draw, material));
    cmd.draw_indexed(indices, draw.index_count, draw.first_index);
  }
}

}  // namespace dermis::passes
