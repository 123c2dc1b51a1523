// SPDX-License-Identifier: MIT
#version 460
#include "render/passes/pixels/open_share/open_share.glsl"
