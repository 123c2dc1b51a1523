// SPDX-License-Identifier: MIT
#version 460
#define LAYER 0
#include "render/passes/pixels/entries/resolve_entries.glsl"
