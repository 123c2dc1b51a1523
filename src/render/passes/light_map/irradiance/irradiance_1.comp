// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 1
#include "render/passes/light_map/irradiance/irradiance.glsl"
