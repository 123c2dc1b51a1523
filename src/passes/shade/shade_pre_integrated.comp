// SPDX-License-Identifier: MIT
#version 460
#include "passes/shade/shade_pre_integrated.glsl"
