// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 3
#include "render/techniques/published/irradiance.glsl"
