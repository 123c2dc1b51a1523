// SPDX-License-Identifier: MIT
// One axis of one step of the cascade, as in passes/blur/blur.glsl. Moving light between maps blurs it too,
// along u and v alike; that is taken off the covariance before it is split into two directions, so that it is
// right under shear.
#include "passes/cascade/cascade_io.h"
#include "shaders/half.glsl"
layout(push_constant, scalar) uniform Push { CascadeIo io; };
layout(binding = 0) uniform sampler2D light_in;
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 2, scalar) readonly buffer Kernels { float kernels[]; };
layout(binding = 6) uniform sampler2D joining;  // light of the same size that has not spread

#include "passes/convolution_taps.glsl"

// Returns the covariance of the step in texels^2: uu, uv, vv.
vec3 covariance(ivec2 p) {
  const ivec2 stretch_texel = ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
  const vec3 l = texelFetch(stretch, stretch_texel, 0).xyz * (0.001 * float(io.side));  // texels per mm
  const vec3 wanted = io.variance_mm2 * vec3(l.x * l.x, l.x * l.y, l.y * l.y + l.z * l.z);

  // Where the map is too coarse for what has been added, no more is taken off than there is.
  const float mean = 0.5 * (wanted.x + wanted.z);
  const float det = max(wanted.x * wanted.z - wanted.y * wanted.y, 0.0);
  const float least = det / max(mean + sqrt(max(mean * mean - det, 0.0)), 1e-20);
  const float off = min(io.moved_texels2, 0.98 * least);
  return wanted - vec3(off, 0.0, off);
}

vec4 computed(ivec2 p, vec4 centre) {
  const float chart = abs(centre.a);  // negative beside lit texels, see passes/dilate
  const vec3 c = covariance(p);
  const float sigma_u = sqrt(c.x);
  const int step_u = max(1, int(ceil(sigma_u / KERNEL_MAX_SIGMA)));
  const float slope_per_texel = c.x > 0.0 ? c.y / c.x : 0.0;
  const float slope = slope_per_texel * float(step_u);  // texels of v per step
  load_kernel(sigma_u / float(step_u), io.texel_averaged != 0u && step_u == 1);

  vec3 sum = vec3(0.0);
  float total = 0.0;
  if (io.axis == 0u) {
    total += gather(sum, centre, chart, kernel_row[0]);
    for (int k = 1; k <= KERNEL_RADIUS; ++k) {
      const float shift = slope * float(k);
      const float whole = floor(shift);
      const float f = shift - whole;
      const ivec2 d = ivec2(k * step_u, int(whole));
      total += gather(sum, light_at(p + d), chart, kernel_row[k] * (1.0 - f));
      total += gather(sum, light_at(p + d + ivec2(0, 1)), chart, kernel_row[k] * f);
      total += gather(sum, light_at(p - d), chart, kernel_row[k] * (1.0 - f));
      total += gather(sum, light_at(p - d - ivec2(0, 1)), chart, kernel_row[k] * f);
    }
    return vec4(storable(sum / total), centre.a);
  }

  float interpolation = 0.0;  // variance in texels^2 that the first pass has added along v
  for (int k = 1; k <= KERNEL_RADIUS; ++k) {
    const float f = fract(slope * float(k));
    interpolation += 2.0 * kernel_row[k] * f * (1.0 - f);
  }
  const float sigma_v = sqrt(max(c.z - slope_per_texel * c.y - interpolation, 0.0));
  const int step_v = max(1, int(ceil(sigma_v / KERNEL_MAX_SIGMA)));
  load_kernel(sigma_v / float(step_v), io.texel_averaged != 0u && step_v == 1);
  total += gather(sum, centre, chart, kernel_row[0]);
  for (int k = 1; k <= KERNEL_RADIUS; ++k) {
    total += gather(sum, light_at(p + ivec2(0, k * step_v)), chart, kernel_row[k]);
    total += gather(sum, light_at(p - ivec2(0, k * step_v)), chart, kernel_row[k]);
  }
  const vec3 joins = io.joins * texelFetch(joining, p + ivec2(io.origin), 0).rgb;
  return vec4(storable(io.scale * (sum / total) + joins), centre.a);
}
