// SPDX-License-Identifier: MIT
#version 460
#include "passes/tone_map/tone_map.glsl"
