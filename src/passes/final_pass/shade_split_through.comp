// SPDX-License-Identifier: MIT
#version 460
#define THROUGH
#include "passes/final_pass/shade_split.glsl"
