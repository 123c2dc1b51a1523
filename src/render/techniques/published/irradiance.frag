// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 0
#include "render/techniques/published/irradiance.glsl"
