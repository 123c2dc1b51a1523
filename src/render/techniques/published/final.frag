// SPDX-License-Identifier: MIT
#version 460
#include "render/techniques/published/final.glsl"
