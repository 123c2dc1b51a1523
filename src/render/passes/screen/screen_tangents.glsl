// SPDX-License-Identifier: MIT
// The tangent plane of a pixel's skin, in the picture. Needs `frame` and
// ScreenIo `io`.

// Moves by one pixel on the tangent plane, mm of the asset.
struct Tangents {
  vec3 right_mm, down_mm;
  float cosine;  // of the plane and the line of sight, as far as it is used
};

const float least_cosine = 0.05;  // an interpolated normal may face away at a silhouette

// The pixel `at` sees the plane of normal n at depth_mm. With rows x, y and w of the camera's matrix, the
// point is where (x - clip.x w, y - clip.y w) vanish. A move g on the plane has dot(n, g) = 0. For a pixel to
// the right it changes the first by clip w times two over the width, and the second by nothing.
Tangents tangents_at(ivec2 at, vec3 n, float depth_mm, float mm_per_unit) {
  const mat4 rows = transpose(frame.camera.clip_from_world);
  const vec2 clip = (2.0 * (vec2(at) + 0.5 - io.picture_low) / io.picture_size - 1.0) * vec2(1.0, -1.0);
  const vec3 a = rows[0].xyz - clip.x * rows[3].xyz, b = rows[1].xyz - clip.y * rows[3].xyz,
             sight = normalize(cross(a, b));

  // Turned so that it faces the eye by least_cosine.
  const vec3 to_eye = dot(sight, frame.camera.direction) < 0.0 ? sight : -sight;
  const float n_v = dot(n, to_eye);
  if (n_v < least_cosine) n = normalize(n + to_eye * (least_cosine - n_v));

  const float w = frame.camera.orthographic != 0u ? 1.0 : length(rows[3].xyz) * depth_mm / mm_per_unit;
  const float scale = w * mm_per_unit / dot(n, cross(a, b));
  Tangents t;
  t.right_mm = cross(b, n) * (scale * 2.0 / io.picture_size.x);
  t.down_mm = cross(n, a) * (-scale * 2.0 / io.picture_size.y);
  t.cosine = max(n_v, least_cosine);
  return t;
}

// Returns the depth of the tangent plane some pixels further, mm. In perspective its inverse is linear.
float plane_depth_mm(Tangents t, float depth_mm, vec2 pixels) {
  const float deeper_mm = dot(frame.camera.direction, pixels.x * t.right_mm + pixels.y * t.down_mm);
  if (frame.camera.orthographic != 0u) return depth_mm + deeper_mm;
  return depth_mm / max(1.0 - deeper_mm / depth_mm, 0.1);
}
