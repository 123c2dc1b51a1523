// SPDX-License-Identifier: MIT
#version 460
#define LAYER 4
#include "passes/entries/resolve_entries.glsl"
