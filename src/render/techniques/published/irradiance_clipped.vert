// SPDX-License-Identifier: MIT
#version 460
#define CLIP
#include "render/techniques/published/texture_space.glsl"
