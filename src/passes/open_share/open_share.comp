// SPDX-License-Identifier: MIT
#version 460
#define MULTISAMPLED
#include "passes/open_share/open_share.glsl"
