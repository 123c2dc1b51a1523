// SPDX-License-Identifier: MIT
// Asks for a draw of a square's texel map, unless it holds what it shall.
#version 460
#include "passes/texel_map/texel_map_io.h"
layout(local_size_x = 1) in;
layout(push_constant, scalar) uniform Push { StaleTexelsIo io; };
layout(binding = 0, scalar) buffer Stamps { uint stamps[]; };
layout(binding = 1, scalar) writeonly buffer Draws { TexelDrawIo draws[]; };

void main() {
  const bool holds = io.stamp != 0u && stamps[io.square] == io.stamp;
  draws[io.square] = TexelDrawIo(io.vertices, holds ? 0u : 1u, 0u, 0u);
  stamps[io.square] = io.stamp;
}
