// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 1
#include "render/techniques/published/irradiance.glsl"
