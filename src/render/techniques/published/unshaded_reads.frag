// SPDX-License-Identifier: MIT
// For each fragment that the final pass shades: counts the read if none of the texels that its bilinear read
// weighs holds light. Bilinear units resolve at most 1/256 of a texel: smaller weights count as none.
#version 460
#include "render/shared/scene_io.h"
#include "render/techniques/published/final_io.h"
layout(early_fragment_tests) in;
layout(push_constant, scalar) uniform Push { PaperFinalIo io; };
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
layout(binding = 8) uniform sampler2D map_base_colour;
#include "render/shaders/cut_out.glsl"
layout(binding = 14) uniform sampler2D light_0;
layout(binding = 15, scalar) buffer Counters { uint counters[]; };
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
#include "render/techniques/published/map_point.glsl"

void main() {
  if (cut_out && is_cut(in_uv, in_colour)) return;
  const vec2 at = map_point() - 0.5;
  const ivec2 corner = ivec2(floor(at));
  const vec2 f = at - vec2(corner);
  bool found = false;
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y);
    const ivec2 p = min(corner + d, ivec2(io.side - 1u));
    found = found || (weight > 1.0 / 256.0 && texelFetch(light_0, p, 0) != vec4(0.0));
  }
  if (!found) atomicAdd(counters[io.slot], 1u);
}
