// SPDX-License-Identifier: MIT
#version 460
layout(local_size_x = 16, local_size_y = 8) in;
layout(push_constant) uniform Push { uvec2 size; };  // pixels
layout(binding = 0, rgba16f) uniform writeonly image2D light;
layout(binding = 1, r32f) uniform writeonly image2D depth_mm;
layout(binding = 2, r32ui) uniform writeonly uimage2D surface;

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, size))) return;
  imageStore(light, ivec2(at), vec4(0.0));
  imageStore(depth_mm, ivec2(at), vec4(0.0));
  imageStore(surface, ivec2(at), uvec4(0u));
}
