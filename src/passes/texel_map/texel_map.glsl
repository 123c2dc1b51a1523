// SPDX-License-Identifier: MIT
// A triangle over the whole square, which clears it, then those of the mesh in its texture coordinates.
// Without index buffer: each triangle has its own number, and is drawn seldom. SEEN: without what faces away
// or lies outside the picture and its margin.
#include "shared/scene_io.h"
#include "shaders/skin_vertex.glsl"
#include "shared/cull_io.h"
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(location = 0) flat out uint out_number;

#ifdef SEEN
#include "shaders/vertex_pull.glsl"
#include "shaders/instance.glsl"
#include "shaders/frame.glsl"
#include "shaders/clip_distances.glsl"
#include "shaders/cull.glsl"
layout(push_constant, scalar) uniform Push { CullIo io; };
layout(constant_id = 0) const bool cull = true;
layout(constant_id = 1) const bool clip = false;
#endif

void main() {
  const uint vertex = uint(gl_VertexIndex);
  out_number = vertex / 3u;
  vec2 at = vec2(vertex & 1u, vertex >> 1) * 4.0 - 1.0;
  if (vertex >= 3u) at = unwrap_of(indices[vertex - 3u]) * 2.0 - 1.0;

#ifdef SEEN
  clip_to_picture(world_position(vertex_position(indices[vertex - 3u])));
  for (int i = 0; i < 5 && !clip; ++i) gl_ClipDistance[i] = 1.0;
  if (cull && io.can_cull != 0u && faces_away(3u * (out_number - 1u))) at = vec2(2.0);
#endif
  gl_Position = vec4(at, 0.5, 1.0);
}
