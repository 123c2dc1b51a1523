// SPDX-License-Identifier: MIT
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/frame.glsl"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
layout(binding = 8) uniform sampler2D map_base_colour;
#include "render/shaders/cut_out.glsl"
layout(constant_id = 0) const bool cull = true;
layout(constant_id = 1) const bool clip = true;
layout(location = 0) in vec3 in_position_m;
layout(location = 1) flat in uint in_culled;
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_colour;
layout(location = 0) out vec4 out_colour;
void main() {
  if (cut_out && is_cut(in_uv, in_colour)) discard;
  bool outside = false;
  for (int i = 0; i < 5; ++i) outside = outside || distance_inside(i, in_position_m) < 0.0;
  const bool culled = cull && in_culled != 0u, clipped = clip && outside;
  out_colour = vec4(clipped ? 0.8 : 0.1, culled || clipped ? 0.1 : 0.7, culled ? 0.9 : 0.1, 1.0);
}
