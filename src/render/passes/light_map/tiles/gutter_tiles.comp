// SPDX-License-Identifier: MIT
// Marks the tiles in which light of seen tiles continues beyond a seam. Also
// those that lend light to texels of seen tiles with nothing of their own chart to repeat. Seen tiles are not
// marked anew, so the order of invocations does not matter.
#version 460
#include "render/passes/light_map/tiles/tiles_io.h"
#include "render/shaders/tile_list.glsl"
#include "render/shared/gutters_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { GutterTilesIo io; };
layout(binding = 0, scalar) readonly buffer Gutters { GutterIo gutters[]; };
layout(binding = 1, scalar) buffer TileMarks { uint tile_marks[]; };

uint tile_at(uvec2 texel) { return io.first_tile + tile_of(texel, io.side); }
uint tile_at(uint packed) { return tile_at(uvec2(packed & 0xFFFFu, packed >> 16)); }
bool is_seen(uint tile) { return (tile_marks[tile] & TILE_SEEN) != 0u; }

void main() {
  const uint i = gl_GlobalInvocationID.y * GUTTER_ROW + gl_GlobalInvocationID.x;
  if (i >= io.count) return;
  const GutterIo g = gutters[i];
  const uint tile = tile_at(g.texel), own = tile_at(g.own), source = tile_at(uvec2(g.source));
  if (is_seen(tile) && (g.own == g.texel || !is_seen(own)))
    atomicOr(tile_marks[source], uint(TILE_SOURCE));
  else if (g.chart != 0u && (is_seen(source) || is_seen(own)))
    atomicOr(tile_marks[tile], uint(TILE_GUTTER));
}
