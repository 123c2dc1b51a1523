// SPDX-License-Identifier: MIT
// One axis of one step of the cascade, as in passes/blur/blur.comp. Moving light between maps blurs it too,
// along u and v alike; that is taken off the covariance before it is split into two directions, so that it is
// right under shear.
#version 460
#include "passes/cascade/cascade_io.h"
#include "shaders/half.glsl"
layout(push_constant, scalar) uniform Push { CascadeIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light_in;
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 6, rgba16f) uniform readonly image2D joining;  // light of the same size that has not spread

#include "passes/convolution_taps.glsl"
#include "passes/cascade/cascade_kernels.glsl"
#include "passes/cascade_level.glsl"

// Returns the covariance of the step in texels^2: uu, uv, vv.
vec3 covariance(ivec2 p) {
  const ivec2 stretch_texel = ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
  const vec3 l = texelFetch(stretch, stretch_texel, 0).xyz * (0.001 * float(io.side));  // texels per mm
  const vec3 wanted = io.variance_mm2 * vec3(l.x * l.x, l.x * l.y, l.y * l.y + l.z * l.z);
  if (io.level.moved_texels2 == 0.0) return wanted;

  const TexelsPerMm texels = texels_per_mm(l);
  const float off = taken_off(io.share * left_after(io.terms_before, texels), io.variance_mm2, texels);
  return wanted - vec3(off, 0.0, off);
}

vec4 own_light(ivec2 p) { return imageLoad(light_in, p + ivec2(io.origin)); }

vec4 spread(ivec2 p, vec4 centre) {
  const float chart = abs(centre.a);  // negative beside lit texels, see passes/dilate
  const int table = io.texel_averaged != 0u ? TABLE_AVERAGED : TABLE_SAMPLED;
  const vec3 c = covariance(p);
  const Kernel across = kernel_of(sqrt(c.x), table);
  const float slope_per_texel = c.x > 0.0 ? c.y / c.x : 0.0;
  const float slope = slope_per_texel * float(across.stride);

  vec3 sum = centre.rgb;
  if (io.axis == 0u) {
    const float total = 1.0 + gather_across(sum, p, chart, across, slope);
    return vec4(storable(sum / total), centre.a);
  }

  const float sigma_v = sqrt(max(c.z - slope_per_texel * c.y - added_between(across, slope), 0.0));
  const float total = 1.0 + gather_along(sum, p, chart, kernel_of(sigma_v, table));
  const vec3 joins = io.joins * imageLoad(joining, p + ivec2(io.origin)).rgb;
  return vec4(storable(io.scale * (sum / total) + joins), centre.a);
}

#include "passes/tiled_pass.glsl"
