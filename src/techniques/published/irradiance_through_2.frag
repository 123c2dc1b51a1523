// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 2
#include "techniques/published/irradiance.glsl"
