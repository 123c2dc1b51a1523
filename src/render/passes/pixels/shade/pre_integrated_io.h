// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_PRE_INTEGRATED_IO_H
#define DERMIS_PASSES_PRE_INTEGRATED_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
// Of a skin mesh: its scattering, integrated beforehand (tissue/gaussians/pre_integrated.h).
struct PreIntegratedIo {
  vec3 scattered;               // share of the light; the rest leaves where it entered
  float mm_per_unit;            // mm of the asset per metre of the world
  float normal_mm;              // sigma by which mapped normals are blurred
  float filter_mm;              // diameter of the disc over which shadows are filtered
  float most_curvature_per_mm;  // of the last row of the table
};
DERMIS_IO_END
#endif
