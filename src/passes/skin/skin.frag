// SPDX-License-Identifier: MIT
#version 460
#include "passes/skin/skin_fragment.glsl"
