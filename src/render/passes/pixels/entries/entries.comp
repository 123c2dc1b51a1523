// SPDX-License-Identifier: MIT
#version 460
#define MULTISAMPLED
#include "render/passes/pixels/entries/entries.glsl"
