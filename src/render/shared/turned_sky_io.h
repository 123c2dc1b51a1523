// SPDX-License-Identifier: MIT
// The sky, and the part of it that the skin of an asset sees, for skin that
// moves.
#ifndef DERMIS_SHARED_TURNED_SKY_IO_H
#define DERMIS_SHARED_TURNED_SKY_IO_H
#include "render/shared/types.h"

// A texel from which skin sees the sky, packed. Row r of texel i lies at [r * count + i], so that neighbours
// read neighbours.
#define SKY_TEXEL_AT 0        // x | y << 16
#define SKY_TEXEL_VERTICES 1  // numbers of the corners of its triangle
#define SKY_TEXEL_WEIGHTS 4   // of the second and third corner, unorm2x16
#define SKY_TEXEL_TRANSFER 5  // environment::Occlusion::transfer, half2 each
#define SKY_TEXEL_BOUNCED 23  // environment::Occlusion::bounced, half2 each; the last half is unused
#define SKY_TEXEL_ROWS 32

#define BOUNCED_HARMONICS 16

DERMIS_IO_BEGIN
// The environment in the coordinates of an asset: environment::SkyHarmonics.
struct SkyHarmonicsIo {
  vec3 sky[36];
  vec3 bouncing_sky[BOUNCED_HARMONICS];
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::SkyHarmonicsIo) == (36 + BOUNCED_HARMONICS) * 12);
#endif
#endif
