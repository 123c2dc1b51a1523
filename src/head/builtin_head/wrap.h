// SPDX-License-Identifier: MIT
// A square net drawn over the bust. Its left and right sides meet along the back
// of the head, its upper side is folded in two over the crown and its lower side under the cut. This gives
// one chart without overlap, one seam, and no pole where triangles would become needles.
#pragma once

#include "head/builtin_head/sculpture.h"

namespace dermis::builtin_head {

/// (columns + 1) x (rows + 1) nodes; node (i, j) is at (i / columns, j / rows), j = 0 below. columns is even.
struct Net {
  int columns = 0, rows = 0;
  std::vector<vec3> at_mm;
  std::vector<vec3> normal;  ///< unit, of the form
  std::vector<vec2> chart;   ///< places on the square of the maps (unwrap.h)

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * (columns + 1) + i; }
  /// Returns the node at (i, j) across the sides: any i, j up to one width beyond.
  std::size_t folded(int i, int j) const;
};

/// Returns the normal of the mesh at node (i, j), from its four neighbours; 0 where the net is folded.
vec3 mesh_normal(const Net& net, int i, int j);

/// Draws the net: evenly spaced (denser where the face needs it), on the form. The same bits on every run.
Net wrap(const Sculpture& bust);

}  // namespace dermis::builtin_head
