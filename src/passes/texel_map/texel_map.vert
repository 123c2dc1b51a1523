// SPDX-License-Identifier: MIT
#version 460
#include "passes/texel_map/texel_map.glsl"
