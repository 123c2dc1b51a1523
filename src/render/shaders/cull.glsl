// SPDX-License-Identifier: MIT
// Finds triangles of a head that no pixel can show. Based on: [JG08] sec. 3,
// where a texel is culled if its interpolated normal is more than 105 degrees from the (constant) view axis.
// On a coarse mesh that culls visible texels, so here whole triangles are culled. All their vertex normals
// are more than 105 degrees from the true direction to the camera, and the triangle faces away. Needs
// vertex_pull.glsl, skin_vertex.glsl, head.glsl, frame.glsl and `indices`.
const float cos_105_degrees = -0.2588190451;

bool faces_away(uint first) {
  const vec3 p = vertex_position(indices[first]);
  const vec3 ab = vertex_position(indices[first + 1]) - p, ac = vertex_position(indices[first + 2]) - p;
  return dot(world_direction(cross(ab, ac)), to_eye(world_position(p))) < 0.0;
}

bool triangle_culled(uint triangle) {
  bool away = faces_away(3u * triangle);
  for (uint i = 0u; i < 3u; ++i) {
    const VertexIo v = vertex_at(indices[3u * triangle + i]);
    const vec3 eye = to_eye(world_position(v.position_m));
    away = away && dot(world_direction(v.normal), eye) < cos_105_degrees * length(eye) * length(v.normal);
  }
  return away;
}
