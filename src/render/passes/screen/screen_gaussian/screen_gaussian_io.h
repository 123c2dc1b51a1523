// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SCREEN_GAUSSIAN_IO_H
#define DERMIS_PASSES_SCREEN_GAUSSIAN_IO_H
#include "render/passes/screen/screen_surface_io.h"
// The rule of the authors' demo, specialisation constant `published`. The width of a kernel is divided by the
// distance plus a multiple of the depth gradient per pixel, which is cut. Their level of 40 makes the kernel
// as wide as it should be at this scale.
#define GAUSSIANS_MM_PER_UNIT 153.1
#define GAUSSIANS_GRADIENT 800.0  // units of distance per unit of depth per pixel
#define GAUSSIANS_MOST_GRADIENT (0.001 * GAUSSIANS_MM_PER_UNIT)  // mm per pixel
#define GAUSSIANS_COT 5.6713  // of half the 20 degrees of their camera, where ours has no angle
DERMIS_IO_BEGIN
// Of a skin mesh of the plan: one Gaussian of its chain.
struct GaussianStepIo {
  float mm_per_unit;  // mm of the asset per metre of the world
  float reach_mm;     // light does not go where skin is as far off the tangent plane
  float sigma_mm;     // of this step
  vec3 weight;        // of the blurred light in the sum
};
DERMIS_IO_END
#endif
