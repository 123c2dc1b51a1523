// SPDX-License-Identifier: MIT
// Charts that lie on each other in the texture coordinates (mirrored halves of a
// face, say) have places of their own in the light map. Else each would show the light of the other.
#pragma once

#include <cstdint>
#include <span>

#include "head/scene/surface/unwrap.h"

namespace dermis::scene {

/// Sorts charts into layers within which they hardly overlap, and lays these side by side, if over 1 % of the
/// covered map belongs to several triangles: changes SkinMesh::unwrap, unwrap_scale and layers. A chart that
/// overlaps itself stays so, and so do triangles that are there twice. `chart`: number of each
/// triangle's chart, no_edge - 1 off the map; each vertex is of one chart. Does nothing where layers would be
/// over `most_layers`.
void lay_charts_apart(SkinMesh& mesh, std::span<const std::uint32_t> chart);

inline constexpr std::size_t most_layers = 16;

}  // namespace dermis::scene
