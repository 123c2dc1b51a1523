// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SCATTER_SUM_IO_H
#define DERMIS_PASSES_SCATTER_SUM_IO_H
#include "render/shared/terms_io.h"
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct SummedTermsIo {
  vec3 weights[MOST_TERMS];  // of the profile, narrow to wide
  float sigma_mm[MOST_TERMS];
};
struct ScatterSumIo {
  float shares[MOST_TERMS];  // MappedTerms::shares; a term without one is not read
  uvec2 origin;              // of the square in the pool, texels
  uint side;                 // T
  uint layer;                // of the light; its rest is in the next
  float shown_mm;            // MappedTerms::shown_mm
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::SummedTermsIo) == 128);
static_assert(sizeof(dermis::io::ScatterSumIo) == 52);
#endif
#endif
