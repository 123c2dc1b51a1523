// SPDX-License-Identifier: MIT
// Adds to each entry of a pixel the light that was blurred there, times what of it leaves.
#version 460
#include "passes/add_scattered/add_scattered_io.h"
#include "shaders/half.glsl"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { AddScatteredIo io; };
layout(binding = 0, scalar) readonly buffer Pixels { PixelIo pixels[]; };
layout(binding = 1, scalar) buffer Entries { EntryIo entries[]; };
layout(binding = 2) uniform sampler2D blurred;
layout(binding = 3) uniform sampler2DArray leaving_skin;

void add(uint id, uint rank, vec3 light) {
  const uint place = entries[(id >> ID_TRIANGLE_BITS) - 1u].x + rank;
  const EntryIo entry = entries[place];
  const vec3 sum = storable(vec3(unpackHalf2x16(entry.x), unpackHalf2x16(entry.y).x) + light);
  entries[place] = EntryIo(packHalf2x16(sum.xy), packHalf2x16(vec2(sum.z, 0.0)));
}

void main() {
  if (gl_GlobalInvocationID.x >= io.size.x) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const PixelIo pixel = pixels[uint(at.y) * io.width + uint(at.x)];
  const uint samples = pixel.rank_first >> RANK_BITS;
  if (samples == 0u) return;

  const vec3 light = texelFetch(blurred, at, 0).rgb;
  if ((samples & 15u) != 0u)
    add(pixel.first, pixel.rank_first & (1u << RANK_BITS) - 1u,
        light * texelFetch(leaving_skin, ivec3(at, 0), 0).rgb);
  if (samples >> 4 != 0u)
    add(pixel.second, pixel.rank_second, light * texelFetch(leaving_skin, ivec3(at, 1), 0).rgb);
}
