// SPDX-License-Identifier: MIT
#include "render/passes/asset/offer.h"

namespace dermis::passes {

void offer_mesh(const Head& head, std::size_t number, Bindings& bindings) {
  const GpuMesh& mesh = head.asset->skin[number];
  bindings.add("VertexExtras", mesh.vertex_extras).add("Indices", mesh.indices);
  if (const PosedShape* posed = head.posed) {
    bindings.add("Vertices", posed->vertices[number])
        .add("SkinVertices", posed->skin_vertices[number])
        .add("TurnedNeighbours", head.asset->rig->skin[number].touching_neighbours);
    return;
  }
  const bool moved = number < head.vertices.size();
  bindings.add("Vertices", moved ? head.vertices[number] : mesh.vertices)
      .add("SkinVertices", mesh.skin_vertices)
      .add("TurnedNeighbours", mesh.turned_neighbours);
}

gpu::BufferBinding placements_of(const Head& head, std::uint32_t page) {
  if (!head.placements.empty()) return head.placements[page];
  return {&head.asset->surfaces.pages[page].placements};
}

void offer_page(const Head& head, std::uint32_t number, Bindings& bindings) {
  const GpuSurfaces::Page& page = head.asset->surfaces.pages[number];
  const PosedShape* posed = head.posed;
  bindings.add("Vertices", posed ? posed->vertices[head.asset->skin.size() + number] : page.vertices)
      .add("VertexExtras", page.vertex_extras)
      .add("Placements", placements_of(head, number));
}

}  // namespace dermis::passes
