// SPDX-License-Identifier: MIT
// Between the four nearest texels of the smaller map, those of the chart alone; of a chart too thin for a
// texel there, any that hold light.
#version 460
#include "passes/upsample/upsample_io.h"
#include "shaders/half.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { UpsampleIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light_in;
layout(binding = 1,
       rgba16f) uniform readonly image2D joining;  // light of the larger size that has not spread
layout(binding = 2, rgba16f) uniform writeonly image2D light_out;
layout(binding = 3) uniform sampler2D stretch;
layout(binding = 4,
       rgba16f) uniform readonly image2D unspread;  // light of the widest terms, of the larger size
#include "passes/cascade_level.glsl"

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, ivec2(io.side)))) return;
  const ivec2 target = p + ivec2(io.origin);
  const vec4 light = imageLoad(joining, target);
  if (light.a == 0.0) {
    imageStore(light_out, target, vec4(0.0));
    return;
  }

  const ivec2 nearest = p / int(io.ratio), last = ivec2(io.side / io.ratio) - 1;
  const ivec2 towards = io.ratio == 1u ? ivec2(0) : 2 * (p & 1) - 1;
  vec4 chart = vec4(0.0), any_chart = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    const ivec2 at = nearest + ivec2(k & 1, k >> 1) * towards;
    if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
    const vec4 texel = imageLoad(light_in, at + ivec2(io.from));
    if (texel.a == 0.0) continue;
    const float weight = ((k & 1) == 0 ? 0.75 : 0.25) * (k < 2 ? 0.75 : 0.25);
    any_chart += weight * vec4(texel.rgb, 1.0);
    if (abs(texel.a) == abs(light.a)) chart += weight * vec4(texel.rgb, 1.0);
  }

  const vec4 found = chart.w > 0.0 ? chart : any_chart;
  vec3 spread = found.w > 0.0 ? found.rgb / found.w : vec3(0.0);
  if (io.level.moved_texels2 > 0.0) {
    const ivec2 stretch_texel = ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
    const vec3 l = texelFetch(stretch, stretch_texel, 0).xyz * (0.001 * float(io.side));  // texels per mm
    const float held = held_by_level(texels_per_mm(l));
    if (held < 1.0) spread = mix(io.spread * imageLoad(unspread, target).rgb, spread, held);
  }
  imageStore(light_out, target, vec4(storable(spread + io.joins * light.rgb), light.a));
}
