// SPDX-License-Identifier: MIT
// Translucent shadow maps for many lights, [JG08] sec. 7. A slab of thickness d,
// lit on its far side with B, shows sum_i w_i exp(-d^2 / 2 v_i) (G(v_i) * B). So every term of the profile
// has light of its own, T_i.
//
// Departure: [DLE07] (GPU Gems 3, ch. 14.5) reads the blurred maps at the texture coordinates of the lit
// point. Those maps hold the light of all lights, which each would read again; and the lit point faces away
// from the eye, where nothing is lit ([JG08] sec. 3). So irradiance.frag collects T_i where light leaves,
// summed over the lights. The convolutions are a chain, narrow to wide, so T_i needs none of its own: the
// excess of T_i over T_(i-1) joins before the step to term i. Terms form three groups at most, or each would
// need a map; sum_i w_i T_i stays exact, only widths are shared (render/passes/light_map/transmission.h).
#version 460
#include "render/shaders/half.glsl"
#include "render/techniques/published/square_io.h"
layout(local_size_x = 32, local_size_y = 2) in;
layout(push_constant, scalar) uniform Push { SquareIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1, rgba16f) uniform image2D through;

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(io.side)))) return;
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  const vec4 spread = texelFetch(light, p, 0);
  if (spread.a == 0.0) return;
  imageStore(through, p, vec4(storable(spread.rgb + imageLoad(through, p).rgb), spread.a));
}
