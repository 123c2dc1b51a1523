// SPDX-License-Identifier: MIT
#version 460
#include "passes/cascade/cascade_blur.glsl"
#include "passes/masked_drawn.glsl"
