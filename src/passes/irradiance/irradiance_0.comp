// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 0
#include "passes/irradiance/irradiance.glsl"
