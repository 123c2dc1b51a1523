// SPDX-License-Identifier: MIT
// Which triangles of a head no pixel can show. Based on: [JG08] sec. 3, where a texel is culled if its interpolated normal is more than
// 105 degrees from the (constant) view axis. Interpolated normals of a coarse mesh cull texels that are seen, so here a triangle goes as a
// whole: all its vertices are beyond 105 degrees from the true direction to the eye, and it faces away. Needs vertex_pull.glsl.
const float cos_105_degrees = -0.2588190451;

// eye: position, w = 1, or the direction towards an orthographic camera, w = 0. `first`: index of the triangle's first corner.
bool triangle_culled(int first, vec3 offset_m, vec4 eye) {
  vec3 p[3];
  bool away = true;
  for (int i = 0; i < 3; ++i) {
    const VertexIo v = vertices[indices[first + i]];
    p[i] = v.position_m + offset_m;
    const vec3 to_eye = eye.w != 0.0 ? eye.xyz - p[i] : eye.xyz;
    away = away && dot(v.normal, to_eye) < cos_105_degrees * length(to_eye) * length(v.normal);
  }
  const vec3 to_eye = eye.w != 0.0 ? eye.xyz - p[0] : eye.xyz;
  return away && dot(cross(p[1] - p[0], p[2] - p[0]), to_eye) < 0.0;
}
