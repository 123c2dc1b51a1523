// SPDX-License-Identifier: MIT
// [JG08] sec. 5: what lies outside the view is clipped although it is drawn in texture coordinates.
#version 460
#define CLIP
#include "passes/irradiance/texture_space.glsl"
