// SPDX-License-Identifier: MIT
// The light of the sky on the texels of moved skin: sky_light() of environment/occlusion.cpp, of what they
// saw of it before, turned with them. Likewise their bent normals.
#version 460
#include "render/passes/pose/turn_sky/turn_sky_io.h"
#include "render/shared/turned_harmonics.h"
#include "render/shared/turned_sky_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { TurnSkyIo io; };
layout(binding = 0, scalar) readonly buffer SkyTexels { uint texels[]; };
layout(binding = 1, scalar) readonly buffer Turns { vec4 turns[]; };
layout(binding = 2, scalar) uniform Sky { SkyHarmonicsIo sky; };
layout(binding = 3) uniform sampler2D rest_bent_normal;
layout(binding = 4, rgba16f) writeonly uniform image2DArray sky_light;
layout(binding = 5, rgba16f) writeonly uniform image2D bent_normal;

uint row(uint r) { return texels[r * io.count + gl_GlobalInvocationID.x]; }

// Returns the rotation of a texel, from those of the corners of its triangle.
vec4 turn_of_texel() {
  const vec2 weights = unpackUnorm2x16(row(SKY_TEXEL_WEIGHTS));
  const vec4 a = turns[row(SKY_TEXEL_VERTICES)], b = turns[row(SKY_TEXEL_VERTICES + 1)],
             c = turns[row(SKY_TEXEL_VERTICES + 2)];
  // q and -q are one rotation.
  return normalize(a * (1.0 - weights.x - weights.y) + b * (dot(a, b) < 0.0 ? -weights.x : weights.x) +
                   c * (dot(a, c) < 0.0 ? -weights.y : weights.y));
}

vec3 turned(vec3 v, vec4 q) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// The series may ring below 0; a half float holds no more than the upper bound.
vec3 storable_light(vec3 e) { return clamp(e, 0.0, 65504.0); }

vec3 direct_light(vec4 q) {
  float transfer[HARMONICS_36];
  for (int k = 0; k < HARMONICS_36 / 2; ++k) {
    const vec2 two = unpackHalf2x16(row(SKY_TEXEL_TRANSFER + k));
    transfer[2 * k] = two.x;
    transfer[2 * k + 1] = two.y;
  }
  turn_harmonics(transfer, q);
  vec3 e = vec3(0.0);
  for (int k = 0; k < HARMONICS_36 / 2; ++k)
    e += transfer[2 * k] * sky.sky[2 * k] + transfer[2 * k + 1] * sky.sky[2 * k + 1];
  return storable_light(e);
}

// Returns the light, and the share of sky that occluders see.
vec4 bounced_light(vec4 q) {
  // Orders 4 and 5 are none, and the compiler leaves them out.
  float transfer[HARMONICS_36];
  for (int k = 0; k < HARMONICS_36 / 2; ++k) transfer[2 * k] = transfer[2 * k + 1] = 0.0;
  for (int k = 0; k < BOUNCED_HARMONICS / 2; ++k) {
    const vec2 two = unpackHalf2x16(row(SKY_TEXEL_BOUNCED + k));
    transfer[2 * k] = two.x;
    transfer[2 * k + 1] = two.y;
  }
  turn_harmonics(transfer, q);
  vec3 e = vec3(0.0);
  for (int k = 0; k < BOUNCED_HARMONICS; ++k) e += transfer[k] * sky.bouncing_sky[k];
  return vec4(storable_light(e), unpackHalf2x16(row(SKY_TEXEL_BOUNCED + BOUNCED_HARMONICS / 2)).x);
}

void main() {
  if (gl_GlobalInvocationID.x >= io.count) return;
  const uint packed_at = row(SKY_TEXEL_AT);
  const ivec2 at = ivec2(packed_at & 0xffffu, packed_at >> 16);
  const vec4 q = turn_of_texel();

  imageStore(sky_light, ivec3(at, 0), vec4(direct_light(q), 1.0));
  imageStore(sky_light, ivec3(at, 1), bounced_light(q));
  const vec4 rest = texelFetch(rest_bent_normal, at, 0);
  imageStore(bent_normal, at, vec4(turned(rest.xyz, q), rest.w));
}
