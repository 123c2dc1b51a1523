// SPDX-License-Identifier: MIT
#version 460
#include "passes/entries/entries.glsl"
