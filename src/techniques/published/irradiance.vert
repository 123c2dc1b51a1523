// SPDX-License-Identifier: MIT
#version 460
#include "techniques/published/texture_space.glsl"
