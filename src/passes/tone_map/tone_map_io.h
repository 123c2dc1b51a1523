// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TONE_MAP_IO_H
#define DERMIS_PASSES_TONE_MAP_IO_H
#include "shared/types.h"
// The values of specialisation constant `tone_map`: those of dermis::ToneMap.
#define TONE_MAP_NATURAL 0u
#define TONE_MAP_NEUTRAL 1u
#define TONE_MAP_AGX 2u
#define TONE_MAP_FILMIC 3u
#define TONE_MAP_SRGB 4u
#define TONE_MAP_LINEAR 5u
DERMIS_IO_BEGIN
// The colour behind the heads.
struct BehindIo {
  vec3 srgb, linear;
};
DERMIS_IO_END
#endif
