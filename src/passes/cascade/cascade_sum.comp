// SPDX-License-Identifier: MIT
// The sum of all terms: what the wide ones have spread, and the narrow ones (narrow_sigma of cascade_steps.h)
// in one pass from the light itself. Their kernels are those of texels as squares, 5 x 5, each the product of
// two directions as in passes/blur/blur.comp. If the last step of the wide ones ran on maps of this size, its
// second axis is done here too.
#version 460
#include "passes/cascade/cascade_io.h"
#include "shaders/half.glsl"
layout(push_constant, scalar) uniform Push { CascadeSumIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light_in;  // of wide terms, after one axis or both
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 6, rgba16f) uniform readonly image2D unspread;
layout(binding = 7, rgba16f) uniform readonly image2D second_group;

#include "passes/convolution_taps.glsl"
#include "passes/cascade/cascade_kernels.glsl"

// Weights per channel of half the 25 taps; the others mirror them. 0..2: along v; 3 + 5 (x - 1) + y + 2: of
// column x = 1, 2.
vec3 weights[13];

float tap(vec3 kernel, int i) {
  const int distance = abs(i);
  return distance == 0 ? kernel.x : distance == 1 ? kernel.y : distance == 2 ? kernel.z : 0.0;
}

// Taps 0, 1, 2 of a narrow Gaussian.
vec3 narrow_kernel(float sigma) {
  const float q = kernel_of(sigma, TABLE_NARROW).q, q2 = q * q;
  const vec3 k = vec3(1.0, q, q2 * q2);
  return k / (1.0 + 2.0 * (k.y + k.z));
}

// Adds one term. A tap that the shear moves off the 5 x 5 is left out; its weight goes to the others.
void add_term(vec3 l, float variance_mm2, vec3 weight) {
  const float slope = l.x > 0.0 ? l.y / l.x : 0.0;
  const vec3 ku = narrow_kernel(sqrt(variance_mm2) * l.x);
  const float f1 = fract(slope), f2 = fract(2.0 * slope);
  const float interpolation = 2.0 * (ku.y * f1 * (1.0 - f1) + ku.z * f2 * (1.0 - f2));
  const vec3 kv = narrow_kernel(sqrt(max(variance_mm2 * l.z * l.z - interpolation, 0.0)));

  float terms[13];
  float total = 0.0;
  for (int y = 0; y <= 2; ++y) {
    terms[y] = ku.x * tap(kv, y);
    total += y == 0 ? terms[y] : 2.0 * terms[y];
  }
  for (int x = 1; x <= 2; ++x) {
    const float shift = slope * float(x);
    const int whole = int(floor(clamp(shift, -8.0, 8.0)));
    const float f = x == 1 ? f1 : f2, across = x == 1 ? ku.y : ku.z;
    for (int y = -2; y <= 2; ++y) {
      const float t = across * mix(tap(kv, y - whole), tap(kv, y - whole - 1), f);
      terms[5 * x + y] = t;
      total += 2.0 * t;
    }
  }
  for (int i = 0; i < 13; ++i) weights[i] += (terms[i] / total) * weight;
}

vec4 unspread_at(ivec2 p) { return none_outside(p, imageLoad(unspread, held_inside(p))); }

// Adds a texel of the same chart; returns its weight.
vec3 add_tap(inout vec3 sum, vec4 texel, float chart, vec3 weight) {
  const vec3 used = abs(texel.a) == chart ? weight : vec3(0.0);
  sum += used * texel.rgb;
  return used;
}

vec3 narrow_terms(ivec2 p, vec4 centre, vec3 l) {
  for (int i = 0; i < 13; ++i) weights[i] = vec3(0.0);
  vec3 wanted = vec3(0.0);
  for (int i = 0; i < int(io.count); ++i) {
    add_term(l, io.variance_mm2[i], io.weights[i]);
    wanted += io.weights[i];
  }

  const float chart = abs(centre.a);
  vec3 sum = vec3(0.0);
  vec3 total = add_tap(sum, centre, chart, weights[0]);
  for (int y = 1; y <= 2; ++y) {
    total += add_tap(sum, unspread_at(p + ivec2(0, y)), chart, weights[y]);
    total += add_tap(sum, unspread_at(p - ivec2(0, y)), chart, weights[y]);
  }
  for (int x = 1; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y) {
      total += add_tap(sum, unspread_at(p + ivec2(x, y)), chart, weights[5 * x + y]);
      total += add_tap(sum, unspread_at(p - ivec2(x, y)), chart, weights[5 * x + y]);
    }
  return sum * wanted / max(total, vec3(1e-12));
}

// Returns what the wide terms have spread, after the second axis of their last step.
vec3 wide_terms(ivec2 p, float chart, vec3 l) {
  vec3 sum = imageLoad(light_in, p + ivec2(io.origin)).rgb;
  if (io.last_step_mm2 == 0.0) return sum;

  const float sigma_mm = sqrt(io.last_step_mm2), slope_per_texel = l.x > 0.0 ? l.y / l.x : 0.0;
  const Kernel across = kernel_of(sigma_mm * l.x, TABLE_AVERAGED);
  const float added = added_between(across, slope_per_texel * float(across.stride)),
              sigma_v = sqrt(max(io.last_step_mm2 * l.z * l.z - added, 0.0));
  const float total = 1.0 + gather_along(sum, p, chart, kernel_of(sigma_v, TABLE_AVERAGED));
  return io.scale * (sum / total);
}

vec4 own_light(ivec2 p) { return imageLoad(unspread, p + ivec2(io.origin)); }

vec4 spread(ivec2 p, vec4 centre) {
  const ivec2 stretch_texel = ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
  const vec3 l = texelFetch(stretch, stretch_texel, 0).xyz * (0.001 * float(io.side));  // texels per mm

  vec3 sum = vec3(0.0);
  if (io.spread != 0u) sum += wide_terms(p, abs(centre.a), l);
  if (io.count != 0u) sum += narrow_terms(p, centre, l);
  if (io.joined != vec3(0.0))
    sum += io.joined * (imageLoad(second_group, p + ivec2(io.origin)).rgb - centre.rgb);
  return vec4(storable(sum), centre.a);
}

#include "passes/tiled_pass.glsl"
