// SPDX-License-Identifier: MIT
// A triangle over the whole square, which clears it, then those of the mesh in its texture coordinates.
// Without index buffer: each triangle has its own number, and is drawn seldom. CLIP: without what lies
// outside the picture and its margin.
#include "shared/scene_io.h"
#include "shaders/skin_vertex.glsl"
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(location = 0) flat out uint out_number;

#ifdef CLIP
#include "shaders/vertex_pull.glsl"
#include "shaders/instance.glsl"
#include "shaders/frame.glsl"
#include "shaders/clip_distances.glsl"
#endif

void main() {
  const uint vertex = uint(gl_VertexIndex);
  out_number = vertex / 3u;
  vec2 at = vec2(vertex & 1u, vertex >> 1) * 4.0 - 1.0;
  if (vertex >= 3u) at = unwrap_of(indices[vertex - 3u]) * 2.0 - 1.0;
  gl_Position = vec4(at, 0.5, 1.0);

#ifdef CLIP
  for (int i = 0; i < 5; ++i) gl_ClipDistance[i] = 1.0;
  if (vertex < 3u) return;
  clip_to_picture(world_position(vertex_position(indices[vertex - 3u])));
#endif
}
