// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 2
#include "render/passes/light_map/irradiance/irradiance.glsl"
