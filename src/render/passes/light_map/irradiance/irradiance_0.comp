// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 0
#include "render/passes/light_map/irradiance/irradiance.glsl"
