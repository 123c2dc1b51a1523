// SPDX-License-Identifier: MIT
#version 460
#include "passes/open_share/open_share.glsl"
