// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/shade/shade_split.glsl"
