// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/add_transmitted/add_transmitted_io.h"
#include "render/shaders/half.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
layout(push_constant, scalar) uniform Push { AddTransmittedIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1, rgba16f) uniform image2D through;

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(io.side)))) return;
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy + io.origin);
  const vec4 spread = texelFetch(light, p, 0);
  if (spread.a == 0.0) return;
  imageStore(through, p, vec4(storable(spread.rgb + imageLoad(through, p).rgb), spread.a));
}
