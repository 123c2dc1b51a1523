// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 2
#include "passes/irradiance/irradiance.glsl"
