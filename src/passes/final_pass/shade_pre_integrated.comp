// SPDX-License-Identifier: MIT
#version 460
#include "passes/final_pass/shade_pre_integrated.glsl"
