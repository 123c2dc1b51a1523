// SPDX-License-Identifier: MIT
#version 460
#define THROUGH
#include "render/passes/pixels/shade/shade_split.glsl"
