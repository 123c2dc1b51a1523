// SPDX-License-Identifier: MIT
#version 460
#define THROUGH
#include "techniques/published/final.glsl"
