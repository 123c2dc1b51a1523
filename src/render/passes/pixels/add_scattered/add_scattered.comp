// SPDX-License-Identifier: MIT
// Adds to each entry of a pixel the light that was blurred there, times what of it leaves.
#version 460
#include "render/passes/pixels/shaded_entry.glsl"
#include "render/passes/pixels/pixel_area_io.h"
#include "render/shaders/half.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { PixelAreaIo io; };
layout(binding = 0, r32ui) uniform readonly uimage2D samples_of_pixels;
layout(binding = 1, rg32ui) uniform uimage2DArray entries_of_pixels;
layout(binding = 2) uniform sampler2D blurred;
layout(binding = 3) uniform sampler2DArray leaving_skin;

void main() {
  if (gl_GlobalInvocationID.x >= io.size.x) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const uint samples = samples_in(imageLoad(samples_of_pixels, at).x);
  if (samples == 0u) return;

  const vec3 light = texelFetch(blurred, at, 0).rgb;
  int e = 0;
  for (uint left = samples; left != 0u; left >>= 4, ++e) {
    const ivec3 place = ivec3(at, e);
    const vec3 rest = radiance_of(imageLoad(entries_of_pixels, place).xy);
    imageStore(entries_of_pixels, place,
               entry_of(storable(rest + light * texelFetch(leaving_skin, place, 0).rgb)));
  }
}
