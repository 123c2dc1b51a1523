// SPDX-License-Identifier: MIT
// Which triangles of a head no pixel can show. Based on: [JG08] sec. 3, where a texel is culled if its
// interpolated normal is more than 105 degrees from the (constant) view axis. Interpolated normals of a
// coarse mesh cull texels that are seen, so here a triangle goes as a whole: all its vertices are beyond 105
// degrees from the true direction to the eye, and it faces away. Needs vertex_pull.glsl.
layout(binding = 28, scalar) readonly buffer TurnedNeighbours {
  uint turned_neighbours[];
};  // scene/turned.h
const float cos_105_degrees = -0.2588190451;
const uint always_kept = 0xFFFFFFFFu;  // as there

bool faces_away(uint first, vec3 offset_m, vec4 eye) {
  const vec3 p = vertices[indices[first]].position_m;
  const vec3 ab = vertices[indices[first + 1]].position_m - p,
             ac = vertices[indices[first + 2]].position_m - p;
  return dot(cross(ab, ac), eye.w != 0.0 ? eye.xyz - (p + offset_m) : eye.xyz) < 0.0;
}

// So thin on a map of this side that no texel's centre may lie in it: an inscribed circle whose radius is
// under 0.75 texels.
bool falls_between_texels(uint first, float map_side) {
  const vec2 a = vertices[indices[first]].unwrap, b = vertices[indices[first + 1]].unwrap,
             c = vertices[indices[first + 2]].unwrap;
  const vec2 ab = b - a, ac = c - a;
  return abs(ab.x * ac.y - ab.y * ac.x) * map_side < 0.75 * (length(ab) + length(ac) + length(c - b));
}

// eye: position, w = 1, or the direction towards an orthographic camera, w = 0.
bool triangle_culled(uint triangle, vec3 offset_m, vec4 eye, float map_side) {
  bool away = faces_away(3u * triangle, offset_m, eye);
  for (uint i = 0u; i < 3u; ++i) {
    const VertexIo v = vertices[indices[3u * triangle + i]];
    const vec3 to_eye = eye.w != 0.0 ? eye.xyz - (v.position_m + offset_m) : eye.xyz;
    away = away && dot(v.normal, to_eye) < cos_105_degrees * length(to_eye) * length(v.normal);
  }
  // One that is seen but holds no texel reads the light of those beside it.
  if (away)
    for (uint k = turned_neighbours[triangle]; k < turned_neighbours[triangle + 1u]; ++k) {
      if (turned_neighbours[k] == always_kept) return false;
      const uint first = 3u * turned_neighbours[k];
      if (falls_between_texels(first, map_side) && !faces_away(first, offset_m, eye)) return false;
    }
  return away;
}
