// SPDX-License-Identifier: MIT
#version 460
#include "shared/scene_io.h"
#include "shared/vertex_pull.glsl"
#include "passes/irradiance/irradiance_io.h"
layout(push_constant, scalar) uniform Push { IrradianceIo io; };
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_tangent;
layout(location = 3) out vec4 out_uv;
layout(location = 4) out vec4 out_colour;
layout(location = 5) flat out uint out_chart;
layout(binding = 13, scalar) readonly buffer Charts { uint charts[]; };
void main() {
  const VertexIo v = pulled_vertex();
  out_position_m = v.position_m + io.offset_m;
  out_normal = v.normal;
  out_tangent = v.tangent;
  out_uv = vec4(v.uv0, v.uv1);
  out_colour = v.colour;
  out_chart = charts[gl_VertexIndex / 3];
  gl_Position = vec4(v.unwrap * 2.0 - 1.0, 0.5, 1.0);
}
