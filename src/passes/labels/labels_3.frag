// SPDX-License-Identifier: MIT
#version 460
#define TARGETS 3
#include "passes/labels/labels_frag.glsl"
