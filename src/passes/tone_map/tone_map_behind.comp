// SPDX-License-Identifier: MIT
#version 460
#define BEHIND
#include "passes/tone_map/tone_map.glsl"
