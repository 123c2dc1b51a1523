// SPDX-License-Identifier: MIT
// Gaussians on whole texels whose weights are powers: q^(k^2) for taps 0, +-1, ..; q is such that the
// variance is exact with the taps that there are (kernels.h). A narrow Gaussian has few taps, so what a texel
// costs follows the density of the unwrap there.
#include "passes/kernels_io.h"
#extension GL_EXT_samplerless_texture_functions : require
layout(binding = 2) uniform utextureBuffer Ratios;  // two cells per texel

#define TABLE_SAMPLED 0
#define TABLE_AVERAGED 1  // of light that is constant over each texel
#define TABLE_NARROW 2    // the same in NARROW_RADIUS taps

struct Kernel {
  float q;
  int taps;    // on either side
  int stride;  // texels from tap to tap
};

Kernel kernel_of(float sigma, int table) {
  const int stride = table == TABLE_NARROW ? 1 : max(1, int(ceil(sigma / RATIO_MAX_SIGMA)));
  const float at = min(sigma / (float(stride) * RATIO_MAX_SIGMA), 1.0) * float(RATIO_CELLS);
  const int cell = min(int(at), RATIO_CELLS - 1);
  const int entry = (stride > 1 ? TABLE_SAMPLED : table) * RATIO_CELLS + cell;
  const vec4 cells = uintBitsToFloat(texelFetch(Ratios, entry / 2));
  const vec2 ends = (entry & 1) == 0 ? cells.xy : cells.zw;
  return Kernel(mix(ends.x, ends.y, at - float(cell)), 1 + cell / RATIO_CELLS_PER_TAP, stride);
}

// Weights of the taps after the middle, one after the other.
struct Weights {
  float weight;  // of this tap
  float ratio;   // of the next tap's weight to it
};
Weights first_tap(Kernel kernel) { return Weights(kernel.q, kernel.q * kernel.q * kernel.q); }
void advance(inout Weights tap, Kernel kernel) {
  tap.weight *= tap.ratio;
  tap.ratio *= kernel.q * kernel.q;
}

// Returns the variance in texels^2 that a pass along u has added along v: its taps lie between two texels.
// slope: texels of v per tap.
float added_between(Kernel kernel, float slope) {
  float sum = 0.0, total = 0.5;
  Weights tap = first_tap(kernel);
  for (int k = 1; k <= kernel.taps; ++k, advance(tap, kernel)) {
    const float f = fract(slope * float(k));
    sum += tap.weight * f * (1.0 - f);
    total += tap.weight;
  }
  return sum / total;
}

// Adds the taps along u, each between two texels of v. Returns their weight.
float gather_across(inout vec3 sum, ivec2 p, float chart, Kernel kernel, float slope) {
  float total = 0.0;
  Weights tap = first_tap(kernel);
  for (int k = 1; k <= kernel.taps; ++k, advance(tap, kernel)) {
    const float shift = slope * float(k), whole = floor(shift), f = shift - whole;
    const ivec2 d = ivec2(k * kernel.stride, int(whole));
    const float near = tap.weight * (1.0 - f), far = tap.weight * f;
    // The tap on the other side is at -shift: its two texels mirror these.
    total += gather(sum, light_at(p + d), chart, near);
    total += gather(sum, light_at(p + d + ivec2(0, 1)), chart, far);
    total += gather(sum, light_at(p - d), chart, near);
    total += gather(sum, light_at(p - d - ivec2(0, 1)), chart, far);
  }
  return total;
}

// Adds the taps along v. Returns their weight.
float gather_along(inout vec3 sum, ivec2 p, float chart, Kernel kernel) {
  float total = 0.0;
  Weights tap = first_tap(kernel);
  for (int k = 1; k <= kernel.taps; ++k, advance(tap, kernel)) {
    const ivec2 d = ivec2(0, k * kernel.stride);
    total += gather(sum, light_at(p + d), chart, tap.weight);
    total += gather(sum, light_at(p - d), chart, tap.weight);
  }
  return total;
}
