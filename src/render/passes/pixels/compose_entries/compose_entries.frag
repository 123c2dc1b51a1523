// SPDX-License-Identifier: MIT
#version 460
#define MULTISAMPLED
#include "render/passes/pixels/compose_entries/compose_entries.glsl"
