// SPDX-License-Identifier: MIT
#version 460
#include "shared/scene_io.h"
#include "shared/vertex_pull.glsl"
#include "shared/placement.glsl"
#include "passes/shadow/shadow_io.h"
layout(push_constant, scalar) uniform Push { ShadowIo io; };
layout(location = 0) out vec2 out_uv0;
layout(location = 1) out vec2 out_uv1;
layout(location = 2) out vec4 out_colour;
void main() {
  const VertexIo v = pulled_vertex();
  out_uv0 = v.uv0;
  out_uv1 = v.uv1;
  out_colour = v.colour;
  gl_Position = io.shadow_from_world * vec4(placed_position(placements[gl_InstanceIndex], v.position_m) + io.offset_m, 1.0);
}
