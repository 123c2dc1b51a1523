// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_FINAL_PASS_IO_H
#define DERMIS_PASSES_FINAL_PASS_IO_H
#include "shared/shape_io.h"
#include "shared/terms.h"
#include "shared/types.h"
DERMIS_IO_BEGIN
struct FinalPassIo {
  vec3 weights[MOST_TERMS];  // of the profile, narrow to wide; a channel sums to 1
  uvec2 map_origin;          // of the head's square in the pool of light maps
  uint map_side;             // T, texels
  uint slot;                 // of the counters, see unshaded_reads.frag
  uint through_rays;         // 1: some of the light of wide terms comes through at the pixel
};
// The terms that maps hold, and the laws of shape.
struct SkinTermsIo {
  float sigma_mm[MOST_TERMS];  // of the Gaussians that maps hold, narrow to wide
  float widest_mm;             // the last of them
  uint first_mapped;           // the first of them, among all terms
  ShapeIo shape;
  float exit_offset_m;  // mean of the channels
  float m_per_mm;       // of the world, of the asset
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::FinalPassIo) == 116);
#endif
#endif
