// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_DISC_GATHER_IO_H
#define DERMIS_PASSES_DISC_GATHER_IO_H
#include "render/passes/screen/screen_surface_io.h"
#include "render/shared/terms_io.h"
// Radii that hold a share x of the light, evenly in sqrt(-ln(1 - x)) from 0 to DISC_MOST_SHARE, per mesh.
#define DISC_RADII 256
#define DISC_MOST_SHARE 3.1
DERMIS_IO_BEGIN
// Of a skin mesh of the plan: its profile, and how far its disc reaches.
struct DiscProfileIo {
  float mm_per_unit;  // mm of the asset per metre of the world
  float reach_mm;     // the radius that holds 99.7 % of the light
  vec3 distance_mm;   // of normalised diffusion, per channel
  uint terms;
  uint widest;                     // channel, by which taps are distributed
  float variance_mm2[MOST_TERMS];  // of the Gaussians
  vec3 weight[MOST_TERMS];         // divided by 2 pi variance: the Gaussian at its middle, 1/mm^2
};
struct DiscTapIo {
  vec2 offset_mm;
  float per_density_mm2;
};
DERMIS_IO_END
#endif
