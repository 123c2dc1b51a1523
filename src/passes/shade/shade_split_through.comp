// SPDX-License-Identifier: MIT
#version 460
#define THROUGH
#include "passes/shade/shade_split.glsl"
