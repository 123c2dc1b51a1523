// SPDX-License-Identifier: MIT
#ifndef DERMIS_HEAD_GLSL
#define DERMIS_HEAD_GLSL
#include "render/shared/scene_io.h"
layout(binding = 33, scalar) uniform Head { HeadIo of_head; };
#endif
