// SPDX-License-Identifier: MIT
// The buffers of a head as it stands: those of its asset, those that a host moves, or those of its pose.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/passes/bindings.h"
#include "render/passes/head.h"

namespace dermis::passes {

/// Offers skin mesh `number` of a head, as its asset counts them: "Vertices", "VertexExtras", "SkinVertices",
/// "Indices", "TurnedNeighbours".
void offer_mesh(const Head& head, std::size_t number, Bindings& bindings);

/// Returns the placements of a page of its surfaces, PlacementIo[].
gpu::BufferBinding placements_of(const Head& head, std::uint32_t page);

/// Offers a page of its surfaces: "Vertices", "VertexExtras", "Placements".
void offer_page(const Head& head, std::uint32_t page, Bindings& bindings);

}  // namespace dermis::passes
