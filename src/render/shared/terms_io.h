// SPDX-License-Identifier: MIT
// The terms of a profile, and the light that comes through the body to them.
#ifndef DERMIS_SHARED_TERMS_IO_H
#define DERMIS_SHARED_TERMS_IO_H
#include "render/shared/types.h"
#define MOST_TERMS 8  // Gaussians of a profile
DERMIS_IO_BEGIN
#define TRANSMISSION_GROUPS 3  // of terms that share a map of transmitted light, at most
#define TRANSMISSION_GAINS 24  // at thicknesses that rise as the square of their number
// Distribution of transmitted light over the groups: see render/passes/light_map/transmission.h.
struct TransmissionIo {
  float falloff_per_m2[MOST_TERMS];  // 1 / (2 v)
  float two_sigma_m[MOST_TERMS];
  uint group[MOST_TERMS];                  // of each term
  vec3 group_weight[TRANSMISSION_GROUPS];  // sum of its terms'
  // part of the light of each term that joins at each group
  vec3 share[TRANSMISSION_GROUPS * MOST_TERMS];
  // Light through a slab of the medium, over that of the Gaussians: render/passes/light_map/transmission.h.
  vec3 gain[TRANSMISSION_GAINS];
  float gains_end_per_m;  // 1 over the thickness of the last
};
DERMIS_IO_END
#endif
