// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SHADE_IO_H
#define DERMIS_PASSES_SHADE_IO_H
#include "render/shared/terms_io.h"
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct ShadeIo {
  vec3 weights[MOST_TERMS];  // of the profile, narrow to wide; a channel sums to 1
  uint map_origin;           // of the head's square in the pool of light maps, x below y: 16 bits each
  uint side;                 // T, texels
  float shown_mm;            // by how much a pixel averages light, as a sigma
  uint through_rays;         // 1: some of the light of wide terms comes through at the pixel
  uint part;
  uint first_triangle;  // of the part, in its mesh
  uint first_row;       // of the band, pixels
  uint width;           // of the targets, pixels
};

// The laws of a profile: ShapeLaws of dermis/profile.h, in mm of the asset.
struct ShapeIo {
  vec3 curvature_mm, convex_mm, concave_mm, difference_mm, difference_mm2;
  vec3 front_share, front_per_mm;
  vec3 exit_grazing, exit_change;  // normal minus grazing
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

// One buffer in place of two: devices may have no more than 32 bindings.
struct ThroughTermsIo {
  SkinTermsIo terms;
  TransmissionIo transmission;  // of all terms
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::ShapeIo) == 27 * 4);
static_assert(sizeof(dermis::io::ShadeIo) == 128);  // of push constants all devices have these
#endif
#endif
