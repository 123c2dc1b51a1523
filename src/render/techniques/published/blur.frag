// SPDX-License-Identifier: MIT
// One axis of one Gaussian of the profile. [DLE07] sec. 3.3: Gaussians are separable; [JG08] listing 3: a
// texel without light ends before its samples.
//
// Departures from the listing, which takes seven taps one sigma apart along u, then v, scaled by the stretch
// map. (1) Those have a variance of 1.079 sigma^2 and miss a lit edge by up to 18 % where texels are as large
// as the Gaussian. Here 13 taps lie on whole texels, with weights of exact variance (kernels.h). (2) u and v
// are not perpendicular: a Gaussian of variance v on the skin has covariance v g^-1 = v L L^T in texture
// coordinates, L = [a 0; b c]. The first pass runs along (a, b) in whole steps of u and interpolates in v;
// the second runs along v, less the variance that interpolation has added. (3) Taps do not cross into another
// chart; beside a seam they read what continues there (seams.comp). (4) Half floats are rounded here, because
// some devices truncate.
#version 460
#extension GL_EXT_samplerless_texture_functions : require
#include "render/techniques/published/blur_io.h"
#include "render/shaders/half.glsl"
layout(push_constant, scalar) uniform Push { PaperBlurIo io; };
layout(constant_id = 0) const bool alpha_test = true;  // else the depth test has rejected what is not lit
layout(binding = 0, rgba16f) uniform readonly image2D light_in;
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 2) uniform utextureBuffer Kernels;
layout(location = 0) out vec4 out_light;

float kernel[PAPER_ROW_FLOATS];

// Takes the kernel from between two rows; rows are so dense that the variance is exact to 1e-4.
void load_kernel(float sigma, bool averaged) {
  const float row = clamp(sigma / PAPER_MAX_SIGMA, 0.0, 1.0) * float(PAPER_ROWS - 1);
  const int whole = min(int(row), PAPER_ROWS - 2),
            texel = ((averaged ? PAPER_ROWS : 0) + whole) * (PAPER_ROW_FLOATS / 4);
  for (int i = 0; i < PAPER_ROW_FLOATS / 4; ++i) {
    const vec4 low = uintBitsToFloat(texelFetch(Kernels, texel + i)),
               high = uintBitsToFloat(texelFetch(Kernels, texel + PAPER_ROW_FLOATS / 4 + i));
    const vec4 part = mix(low, high, row - float(whole));
    for (int k = 0; k < 4; ++k) kernel[4 * i + k] = part[k];
  }
}

// Outside the used square there is nothing: that is left over from another T.
vec4 light_at(ivec2 p) {
  const ivec2 held = clamp(p, ivec2(0), ivec2(io.side) - 1);
  const vec4 texel = imageLoad(light_in, held);
  return held == p ? texel : vec4(0.0);
}

// Adds a texel unless it is unlit or of another chart; returns its weight.
float gather(inout vec3 sum, vec4 texel, float chart, float weight) {
  const float used = texel.a == chart ? weight : 0.0;
  sum += used * texel.rgb;
  return used;
}

void main() {
  const ivec2 p = ivec2(gl_FragCoord.xy);
  const vec4 centre = imageLoad(light_in, p);
  if (alpha_test && centre.a == 0.0) discard;  // listing 3

  const float chart = centre.a;
  const ivec2 stretch_texel = ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
  const vec3 factor = texelFetch(stretch, stretch_texel, 0).xyz * 0.001;  // per mm
  const float texels = float(io.side);
  const float sigma_mm = sqrt(io.variance_mm2);
  const float sigma_u = sigma_mm * factor.x * texels;
  const int step_u = max(1, int(ceil(sigma_u / PAPER_MAX_SIGMA)));
  const float slope = factor.x > 0.0 ? factor.y / factor.x * float(step_u) : 0.0;  // texels of v per step
  load_kernel(sigma_u / float(step_u), io.texel_averaged != 0u && step_u == 1);

  vec3 sum = vec3(0.0);
  float total = 0.0;
  if (io.axis == 0u) {
    total += gather(sum, centre, chart, kernel[0]);
    for (int k = 1; k <= PAPER_TAPS; ++k) {
      const float shift = slope * float(k), whole = floor(shift), f = shift - whole;
      const ivec2 d = ivec2(k * step_u, int(whole));
      // The tap on the other side is at -shift: its two texels mirror these.
      total += gather(sum, light_at(p + d), chart, kernel[k] * (1.0 - f));
      total += gather(sum, light_at(p + d + ivec2(0, 1)), chart, kernel[k] * f);
      total += gather(sum, light_at(p - d), chart, kernel[k] * (1.0 - f));
      total += gather(sum, light_at(p - d - ivec2(0, 1)), chart, kernel[k] * f);
    }
  } else {
    float interpolation = 0.0;  // variance in texels^2 that the first pass has added along v
    for (int k = 1; k <= PAPER_TAPS; ++k) {
      const float f = fract(slope * float(k));
      interpolation += 2.0 * kernel[k] * f * (1.0 - f);
    }

    const float wanted = sigma_mm * factor.z * texels;
    const float sigma_v = sqrt(max(wanted * wanted - interpolation, 0.0));
    const int step_v = max(1, int(ceil(sigma_v / PAPER_MAX_SIGMA)));
    load_kernel(sigma_v / float(step_v), io.texel_averaged != 0u && step_v == 1);

    total += gather(sum, centre, chart, kernel[0]);
    for (int k = 1; k <= PAPER_TAPS; ++k) {
      total += gather(sum, light_at(p + ivec2(0, k * step_v)), chart, kernel[k]);
      total += gather(sum, light_at(p - ivec2(0, k * step_v)), chart, kernel[k]);
    }
  }
  // Weights are renormalised at open borders, where no skin continues.
  out_light = vec4(storable(sum / total), centre.a);
}
