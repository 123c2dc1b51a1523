// SPDX-License-Identifier: MIT
#include "render/passes/asset/posed.h"

namespace dermis::passes {

void offer_mesh(const Instance& instance, std::size_t number, Bindings& bindings) {
  const GpuMesh& mesh = instance.asset->skin[number];
  bindings.add("VertexExtras", mesh.vertex_extras).add("Indices", mesh.indices);
  if (const PosedShape* posed = instance.posed) {
    bindings.add("Vertices", posed->vertices[number])
        .add("SkinVertices", posed->skin_vertices[number])
        .add("TurnedNeighbours", instance.asset->rig->skin[number].touching_neighbours);
    return;
  }
  const bool moved = number < instance.vertices.size();
  bindings.add("Vertices", moved ? instance.vertices[number] : mesh.vertices)
      .add("SkinVertices", mesh.skin_vertices)
      .add("TurnedNeighbours", mesh.turned_neighbours);
}

gpu::BufferBinding placements_of(const Instance& instance, std::uint32_t page) {
  if (!instance.placements.empty()) return instance.placements[page];
  return {&instance.asset->surfaces.pages[page].placements};
}

void offer_page(const Instance& instance, std::uint32_t number, Bindings& bindings) {
  const GpuSurfaces::Page& page = instance.asset->surfaces.pages[number];
  const PosedShape* posed = instance.posed;
  bindings.add("Vertices", posed ? posed->vertices[instance.asset->skin.size() + number] : page.vertices)
      .add("VertexExtras", page.vertex_extras)
      .add("Placements", placements_of(instance, number));
}

}  // namespace dermis::passes
