// SPDX-License-Identifier: MIT
// The chart of a texel is that at its centre, as in maps drawn at this size; the mean leaves out texels of
// other charts.
#version 460
#include "shared/types.h"
#include "shared/gutters_io.h"
#include "shaders/half.glsl"
#include "passes/downsample/downsample_io.h"
layout(local_size_x = 16, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { DownsampleIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light_in;
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 2, rgba16f) uniform writeonly image2D light_out;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, ivec2(io.side)))) return;

  const float chart =
      texelFetch(stretch, ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side))), 0).a;

  vec3 sum = vec3(0.0), strange = vec3(0.0);
  float total = 0.0, strangers = 0.0;
  bool lit = false;
  // A head that uses fewer texels than T_max halves less often: its light is copied.
  const bool halves = io.ratio == 2u;
  const int n = halves ? 4 : 1;
  const ivec2 corner = p * int(io.ratio) - (halves ? 1 : 0);
  for (int i = 0; i < n * n; ++i) {
    const ivec2 k = ivec2(i % n, i / n), at = corner + k;
    if (halves && (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, ivec2(io.side * io.ratio)))))
      continue;
    const vec4 texel = imageLoad(light_in, at + ivec2(io.from));
    if (texel.a == 0.0) continue;
    const bvec2 inner = equal(k >> 1, 1 - (k & 1));
    const float weight = halves ? (inner.x ? 3.0 : 1.0) * (inner.y ? 3.0 : 1.0) : 1.0;
    strange += weight * texel.rgb;
    strangers += weight;
    if (abs(texel.a) != chart) continue;
    sum += weight * texel.rgb;
    total += weight;
    lit = lit || texel.a > 0.0;
  }

  vec4 mean = vec4(0.0);
  if (total > 0.0)
    mean = vec4(round_to_half(sum / total), lit ? chart : -chart);
  else if (strangers >
           0.0)  // beside an open border, or of a chart thinner than this texel: for bilinear reads only
    mean = vec4(round_to_half(strange / strangers), BORDER_ALPHA);

  imageStore(light_out, p + ivec2(io.origin), mean);
}
