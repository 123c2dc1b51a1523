// SPDX-License-Identifier: MIT
// What convolutions along the charts of a light map share: taps that stay in the chart. Needs `io` with
// `origin` and `side` of the square, and `light_in`. That is a storage image, and coordinates are held inside
// in place of a branch: reading it through a sampler, whose level may differ per invocation, takes twice as
// long on the software driver (docs/measuring.md).

// p: texel of the square. Outside its used part nothing is read: that is left over from another T.
vec4 light_at(ivec2 p) {
  const ivec2 inside = clamp(p, ivec2(0), ivec2(io.side) - 1);
  const vec4 texel = imageLoad(light_in, inside + ivec2(io.origin));
  return inside == p ? texel : vec4(0.0);
}

// Adds a texel unless it belongs to no chart or to another; returns its weight.
float gather(inout vec3 sum, vec4 texel, float chart, float weight) {
  const float used = abs(texel.a) == chart ? weight : 0.0;
  sum += used * texel.rgb;
  return used;
}
