// SPDX-License-Identifier: MIT
// Counts texels by their alpha. Integers, so the order of additions does not matter.
#version 460
#include "render/passes/finish/count/count_io.h"
#include "render/shared/types.h"
layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push { CountIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1, scalar) buffer Counters { uint counters[]; };
shared uint group_count;

void main() {
  if (gl_LocalInvocationIndex == 0u) group_count = 0u;
  barrier();
  const uvec2 p = gl_GlobalInvocationID.xy;
  if (all(lessThan(p, io.extent))) {
    const float alpha = texelFetch(picture, ivec2(p + io.origin), 0).a;
    if (alpha >= io.threshold) atomicAdd(group_count, 1u);
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u && group_count > 0u) atomicAdd(counters[io.slot], group_count);
}
