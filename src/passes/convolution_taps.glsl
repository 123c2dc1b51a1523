// SPDX-License-Identifier: MIT
// What convolutions along the charts of a light map share: kernels by their width, and taps that stay in the
// chart. Needs `io` with `origin` and `side` of the square, `light_in` and `Kernels`.
#include "passes/kernels_io.h"

// Weights of taps 0..KERNEL_RADIUS and the variance, between two rows of the table; rows are so dense that
// the variance is exact to 1e-4.
float kernel_row[KERNEL_FLOATS];
void load_kernel(float sigma, bool averaged) {
  const float at = clamp(sigma / KERNEL_MAX_SIGMA, 0.0, 1.0) * float(KERNEL_ROWS - 1);
  const int row = min(int(at), KERNEL_ROWS - 2);
  const float f = at - float(row);
  const int base = ((averaged ? KERNEL_ROWS : 0) + row) * KERNEL_FLOATS;
  for (int i = 0; i < KERNEL_FLOATS; ++i)
    kernel_row[i] = mix(kernels[base + i], kernels[base + KERNEL_FLOATS + i], f);
}

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
