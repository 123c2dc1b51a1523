// SPDX-License-Identifier: MIT
#version 460
#define TARGETS 4
#include "render/passes/pixels/labels/labels_frag.glsl"
