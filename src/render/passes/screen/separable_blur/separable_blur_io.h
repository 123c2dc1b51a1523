// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SEPARABLE_BLUR_IO_H
#define DERMIS_PASSES_SEPARABLE_BLUR_IO_H
#include "render/passes/screen/screen_surface_io.h"
// The kernel of the authors: specialisation constant `published`. Millimetres per scene unit of the demo that
// their constants belong to: a head of 1.4696 units that was 421.1 mm tall in the scan.
#define PUBLISHED_MM_PER_UNIT 286.5
#define PUBLISHED_WIDTH_MM (0.012 * PUBLISHED_MM_PER_UNIT)
#define PUBLISHED_FOLLOW 300.0
#define PUBLISHED_COT 5.6713  // of half the 20 degrees of the demo's camera, where ours has no angle
DERMIS_IO_BEGIN
// Of a skin mesh of the plan, before its taps.
struct LineKernelIo {
  float mm_per_unit;  // mm of the asset per metre of the world
  float reach_mm;     // of the outer taps
};
struct LineTapIo {
  float offset;  // mm of the asset; published: the authors' unit
  vec3 weight;
};
DERMIS_IO_END
#endif
