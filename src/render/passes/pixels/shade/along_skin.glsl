// SPDX-License-Identifier: MIT
layout(constant_id = 18) const bool shape_aware = false;  // the profile has laws of shape

// Change of unwrap coordinates over a triangle, per metre of the world.
struct AlongSkin {
  vec3 u, v;
};

AlongSkin along_triangle(vec3 a, vec3 b, vec3 c, vec2 unwrap_a, vec2 unwrap_b, vec2 unwrap_c) {
  const vec3 ab = b - a, ac = c - a, across = cross(ab, ac);
  const float area2 = max(dot(across, across), 1e-30);
  const vec3 of_b = cross(ac, across) / area2, of_c = cross(across, ab) / area2;
  const vec2 to_b = unwrap_b - unwrap_a, to_c = unwrap_c - unwrap_a;
  return AlongSkin(to_b.x * of_b + to_c.x * of_c, to_b.y * of_b + to_c.y * of_c);
}

// Where the skin is on its light map.
struct OnMap {
  vec2 unwrap;      // in its triangle
  float uv_per_mm;  // texture coordinates
  vec4 shape;       // body_shape()
  AlongSkin along;
};
