// SPDX-License-Identifier: MIT
// Where a fragment reads the light maps. Needs `io`.
// Centroid: beside a silhouette or a seam the centre of the pixel may be off the triangle, where the map may
// be empty.
layout(location = 5) centroid in vec2 in_unwrap;
layout(location = 6) flat in vec4 in_unwrap_ab;  // the triangle's corners
layout(location = 7) flat in vec2 in_unwrap_c;

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Keeps an unwrap coordinate in the triangle: at grazing angles even a sample on the triangle may be
// interpolated far outside of it.
vec2 within_triangle(vec2 p) {
  const vec2 a = in_unwrap_ab.xy, ab = in_unwrap_ab.zw - a, ac = in_unwrap_c - a;
  const float area = cross2(ab, ac), b_share = cross2(p - a, ac) / area, c_share = cross2(ab, p - a) / area;
  const vec3 share = vec3(1.0 - b_share - c_share, b_share, c_share);
  if (all(greaterThanEqual(share, vec3(0.0)))) return p;
  const vec3 kept = max(share, vec3(0.0));
  // A triangle without area on the map has no barycentric coordinates; its box still contains p.
  if (!(abs(area) > 0.0)) return clamp(p, min(a, min(a + ab, a + ac)), max(a, max(a + ab, a + ac)));
  return a + (kept.y * ab + kept.z * ac) / (kept.x + kept.y + kept.z);
}

// [JG08] sec. 4: texture space is limited to (0..s). Returns texels, with the bilinear footprint inside the
// used square: half a texel, plus the step to which samplers round. Outside there may be NaN, which a weight
// of 0 does not remove.
vec2 map_point() {
  const float margin = 0.5 + 1.0 / 256.0, side = float(io.side);
  return clamp(within_triangle(in_unwrap) * side, margin, side - margin);
}
