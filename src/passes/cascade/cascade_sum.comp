// SPDX-License-Identifier: MIT
#version 460
#include "passes/cascade/cascade_sum.glsl"
#include "passes/masked_computed.glsl"
