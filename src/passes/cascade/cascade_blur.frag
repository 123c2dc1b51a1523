// SPDX-License-Identifier: MIT
// Drawn over the square. Unlit texels of the target keep the clear value: by the alpha test
// here, or because the depth test has rejected the fragment.
#version 460
#include "passes/cascade/cascade_blur.glsl"
layout(constant_id = 0) const bool alpha_test = true;
layout(location = 0) out vec4 out_light;

void main() {
  const ivec2 p = ivec2(gl_FragCoord.xy) - ivec2(io.origin);
  const vec4 centre = texelFetch(light_in, p + ivec2(io.origin), 0);
  if (alpha_test && centre.a == 0.0) discard;
  out_light = computed(p, centre);
}
