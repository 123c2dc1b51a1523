// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/compose_entries/compose_entries.glsl"
