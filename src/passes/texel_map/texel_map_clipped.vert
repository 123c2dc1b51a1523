// SPDX-License-Identifier: MIT
// Of triangles that share texels, each takes only those where it is lit: see texel.glsl of the irradiance.
#version 460
#define CLIP
#include "passes/texel_map/texel_map.glsl"
