// SPDX-License-Identifier: MIT
#version 460
#define LAYER 1
#include "passes/entries/resolve_entries.glsl"
