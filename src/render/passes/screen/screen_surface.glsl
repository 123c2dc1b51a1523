// SPDX-License-Identifier: MIT
// Packs and reads what screen_surface_io.h stores per pixel.
#include "render/passes/screen/screen_surface_io.h"

// Normals on an octahedron, unfolded. Based on: Cigolle, Donow, Evangelakos et al.: A Survey of Efficient
// Representations for Independent Unit Vectors. JCGT 3(2), 2014.
uint packed_surface(uint head, vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  const vec2 sides = vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  const vec2 at = n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * sides;
  const uvec2 cell = uvec2(round(clamp(at * 0.5 + 0.5, 0.0, 1.0) * 1022.0));  // an even number: 0 is exact
  return (head + 1u) << SURFACE_NORMAL_BITS | cell.y << 10 | cell.x;
}

// Returns head + 1; 0: no skin.
uint head_of(uint surface) { return surface >> SURFACE_NORMAL_BITS; }

vec3 normal_of(uint surface) {
  const vec2 at = vec2(surface & 1023u, surface >> 10 & 1023u) * (2.0 / 1022.0) - 1.0;
  vec3 n = vec3(at, 1.0 - abs(at.x) - abs(at.y));
  const float fold = max(-n.z, 0.0);
  n.xy -= fold * vec2(n.x >= 0.0 ? 1.0 : -1.0, n.y >= 0.0 ? 1.0 : -1.0);
  return normalize(n);
}
