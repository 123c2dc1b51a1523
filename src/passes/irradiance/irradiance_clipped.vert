// SPDX-License-Identifier: MIT
// [JG08] sec. 5: clips skin outside the view although it is drawn in texture coordinates.
#version 460
#define CLIP
#include "passes/irradiance/texture_space.glsl"
