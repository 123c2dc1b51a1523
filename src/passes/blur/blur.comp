// SPDX-License-Identifier: MIT
#version 460
#include "passes/blur/blur.glsl"
#include "passes/masked_computed.glsl"
