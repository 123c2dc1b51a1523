// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_TONE_MAP_IO_H
#define DERMIS_PASSES_TONE_MAP_IO_H
#include "render/shared/types.h"
// The values of specialisation constant `tone_map`: those of dermis::ToneMap.
#define TONE_MAP_NATURAL 0u
#define TONE_MAP_NEUTRAL 1u
#define TONE_MAP_AGX 2u
#define TONE_MAP_FILMIC 3u
#define TONE_MAP_SRGB 4u
#define TONE_MAP_LINEAR 5u
DERMIS_IO_BEGIN
struct ToneMapIo {
  vec3 srgb, linear;                    // the colour behind the heads
  float narrow, wide;                   // shares of spread light, 0..1
  uint narrow_halvings, wide_halvings;  // of their sizes, from the picture's
};
DERMIS_IO_END
#endif
