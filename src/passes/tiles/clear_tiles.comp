// SPDX-License-Identifier: MIT
// Empties the tiles of a map that have none of these marks. A workgroup is a tile.
#version 460
#include "passes/tiles/tiles_io.h"
#include "shaders/tile_list.glsl"
layout(local_size_x = TILE_WIDTH, local_size_y = TILE_HEIGHT) in;
layout(push_constant, scalar) uniform Push { ClearTilesIo io; };
layout(binding = 0, rgba16f) uniform writeonly image2D light;
layout(binding = 1, scalar) readonly buffer TileMarks { uint tile_marks[]; };

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, uvec2(io.side)))) return;
  if ((tile_marks[io.first_tile + tile_of(at, io.side)] & io.kept) == 0u)
    imageStore(light, ivec2(io.origin + at), vec4(0.0));
}
