// SPDX-License-Identifier: MIT
#version 460
#define LAYER 1
#include "render/passes/pixels/entries/resolve_entries.glsl"
