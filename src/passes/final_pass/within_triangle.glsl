// SPDX-License-Identifier: MIT
// The unwrap coordinate of a fragment, in its triangle.
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
