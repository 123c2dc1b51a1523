// SPDX-License-Identifier: MIT
// Of triangles that share texels, those that a pixel may show: see seen_tiles.comp.
#version 460
#define SEEN
#include "passes/texel_map/texel_map.glsl"
