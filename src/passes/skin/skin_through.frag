// SPDX-License-Identifier: MIT
#version 460
#define THROUGH
#include "passes/skin/skin_fragment.glsl"
