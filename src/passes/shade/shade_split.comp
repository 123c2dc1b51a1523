// SPDX-License-Identifier: MIT
#version 460
#include "passes/shade/shade_split.glsl"
