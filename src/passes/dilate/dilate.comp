// SPDX-License-Identifier: MIT
// The alpha of written texels is not read, so the order of invocations does not matter.
#version 460
#include "shared/types.h"
#include "shared/gutters_io.h"
#include "shaders/half.glsl"
#include "shaders/tile_list.glsl"
#include "passes/dilate/dilate_io.h"
layout(local_size_x = TILE_WIDTH, local_size_y = TILE_HEIGHT) in;
layout(push_constant, scalar) uniform Push { DilateIo io; };
layout(binding = 0, rgba16f) uniform image2D light;
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 2, scalar) readonly buffer Tiles { uint tiles[]; };
layout(binding = 3, scalar) readonly buffer TileCounts { TileCountsIo tile_counts[]; };

// On heads with triangles smaller than a texel, a visible one may be up to three texels away from the nearest
// lit centre.
const int reach = 3;

void main() {
  const uint i = tile_number(gl_WorkGroupID.xy);
  if (i >= tile_counts[io.square].listed) return;

  const ivec2 p = tile_corner(tiles[io.first_tile + i]) + ivec2(gl_LocalInvocationID.xy),
              origin = ivec2(io.origin);
  if (any(greaterThanEqual(uvec2(p), uvec2(io.side)))) return;
  if (imageLoad(light, origin + p).a != 0.0) return;

  const float chart =
      texelFetch(stretch, ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side))), 0).a;

  // Sums the lit neighbours of this chart, and those of any.
  vec4 same = vec4(0.0), any_chart = vec4(0.0);
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      const ivec2 q = p + ivec2(x, y);
      if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, ivec2(io.side)))) continue;
      const vec4 texel = imageLoad(light, origin + q);
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
    imageStore(light, origin + p, vec4(round_to_half(sum.rgb / sum.w), same.w > 0.0 ? -chart : BORDER_ALPHA));
}
