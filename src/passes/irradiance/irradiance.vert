// SPDX-License-Identifier: MIT
#version 460
#include "passes/irradiance/texture_space.glsl"
