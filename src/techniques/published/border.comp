// SPDX-License-Identifier: MIT
// Fills unlit texels beside lit ones of their chart with the nearest light, because bilinear reads of visible
// points may reach them. Alpha is the chart's number, negative. Departure: [JG08] lacks light in these
// texels. The alpha of written texels is not read, so the order of invocations does not matter.
#version 460
#include "shared/gutters_io.h"
#include "shaders/half.glsl"
#include "techniques/published/square_io.h"
layout(local_size_x = 32, local_size_y = 2) in;
layout(push_constant, scalar) uniform Push { SquareIo io; };
layout(binding = 0, rgba16f) uniform image2D light;
layout(binding = 1) uniform sampler2D stretch;

// On heads with triangles smaller than a texel, a visible one may be up to three texels away from the nearest
// lit centre.
const int reach = 3;

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, ivec2(io.side)))) return;
  if (imageLoad(light, p).a != 0.0) return;
  const float chart =
      texelFetch(stretch, ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side))), 0).a;

  // Sums the lit neighbours of this chart, and those of any.
  vec4 same = vec4(0.0), any_chart = vec4(0.0);
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      const ivec2 q = p + ivec2(x, y);
      if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, ivec2(io.side)))) continue;
      const vec4 texel = imageLoad(light, q);
      // Nearest first: each step outwards weighs a hundredth.
      const float weight =
          texel.a > 0.0 && texel.a != BORDER_ALPHA ? exp2(-6.64 * float(max(abs(x), abs(y)))) : 0.0;
      any_chart += weight * vec4(texel.rgb, 1.0);
      if (texel.a == chart) same += weight * vec4(texel.rgb, 1.0);
    }

  // An unlit chart may be so close to a lit one that reads of the lit one touch it: light for bilinear reads
  // only.
  const vec4 sum = same.w > 0.0 ? same : any_chart;
  if (sum.w > 0.0)
    imageStore(light, p, vec4(round_to_half(sum.rgb / sum.w), same.w > 0.0 ? -chart : BORDER_ALPHA));
}
