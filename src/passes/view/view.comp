// SPDX-License-Identifier: MIT
// Linear radiance to display values.
#version 460
#include "shared/types.h"
#include "passes/view/view_io.h"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ViewIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1, rgba8) uniform writeonly image2D display;

// Narkowicz, "ACES Filmic Tone Mapping Curve", 2015.
vec3 filmic(vec3 x) { return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), vec3(0.0), vec3(1.0)); }
vec3 srgb(vec3 x) {
  x = clamp(x, vec3(0.0), vec3(1.0));
  return mix(12.92 * x, 1.055 * pow(max(x, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055, greaterThan(x, vec3(0.0031308)));
}

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(display)))) return;
  const vec4 radiance = texelFetch(picture, p, 0);
  vec3 shown = clamp(radiance.rgb, vec3(0.0), vec3(1.0));
  if (io.transform == VIEW_FILMIC) shown = srgb(filmic(radiance.rgb));
  if (io.transform == VIEW_SRGB) shown = srgb(radiance.rgb);
  imageStore(display, p, vec4(shown, 1.0));
}
