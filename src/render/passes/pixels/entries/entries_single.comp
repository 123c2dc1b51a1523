// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/entries/entries.glsl"
