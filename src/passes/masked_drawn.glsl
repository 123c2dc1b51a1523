// SPDX-License-Identifier: MIT
// A masked pass drawn over the square; needs what masked_computed.glsl needs. Unlit texels of the target keep
// the clear value: by the alpha test here, or because the depth test has rejected the fragment.
layout(constant_id = 0) const bool alpha_test = true;
layout(location = 0) out vec4 out_light;

void main() {
  const ivec2 p = ivec2(gl_FragCoord.xy) - ivec2(io.origin);
  const vec4 own = own_light(p);
  if (alpha_test && own.a == 0.0) discard;
  out_light = spread(p, own);
}
