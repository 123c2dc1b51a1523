// SPDX-License-Identifier: MIT
#version 460
#define GROUPS 1
#include "passes/irradiance/irradiance.glsl"
