// SPDX-License-Identifier: MIT
// What convolutions along the charts of a light map share: taps that stay in the chart. Needs `io` with
// `origin` and `side` of the square, and `light_in`.

// p: texel of the square. Outside its used part nothing is read: that is left over from another T.
vec4 light_at(ivec2 p) {
  if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, ivec2(io.side)))) return vec4(0.0);
  return texelFetch(light_in, p + ivec2(io.origin), 0);
}

// Adds a texel unless it belongs to no chart or to another; returns its weight.
float gather(inout vec3 sum, vec4 texel, float chart, float weight) {
  const float used = abs(texel.a) == chart ? weight : 0.0;
  sum += used * texel.rgb;
  return used;
}
