// SPDX-License-Identifier: MIT
// What convolutions along the charts of a light map share: taps that stay in the chart. Needs `io` with
// `origin` and `side` of the square, and `light_in`. That is a storage image, and coordinates are held inside
// in place of a branch: reading it through a sampler, whose level may differ per invocation, takes twice as
// long on the software driver (docs/measuring.md).

// p: texel of the square. Outside its used part there is nothing: that is left over from another T.
ivec2 held_inside(ivec2 p) { return clamp(p, ivec2(0), ivec2(io.side) - 1) + ivec2(io.origin); }
vec4 none_outside(ivec2 p, vec4 texel) { return held_inside(p) == p + ivec2(io.origin) ? texel : vec4(0.0); }

vec4 light_at(ivec2 p) { return none_outside(p, imageLoad(light_in, held_inside(p))); }

// Adds a texel unless it belongs to no chart or to another; returns its weight.
float gather(inout vec3 sum, vec4 texel, float chart, float weight) {
  const float used = texel.a == chart ? weight : 0.0;
  sum += used * texel.rgb;
  return used;
}
