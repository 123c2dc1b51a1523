// SPDX-License-Identifier: MIT
#version 460
#define MULTISAMPLED
#include "passes/compose_entries/compose_entries.glsl"
