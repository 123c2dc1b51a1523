// SPDX-License-Identifier: MIT
#version 460
#define MULTISAMPLED
#include "passes/entries/entries.glsl"
