// SPDX-License-Identifier: MIT
#version 460
#define CLIP
#include "techniques/published/texture_space.glsl"
