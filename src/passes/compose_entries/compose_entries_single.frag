// SPDX-License-Identifier: MIT
#version 460
#include "passes/compose_entries/compose_entries.glsl"
