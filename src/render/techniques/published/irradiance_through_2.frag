// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 2
#include "render/techniques/published/irradiance.glsl"
