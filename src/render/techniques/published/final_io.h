// SPDX-License-Identifier: MIT
#ifndef DERMIS_PUBLISHED_FINAL_IO_H
#define DERMIS_PUBLISHED_FINAL_IO_H
#include "render/shared/terms_io.h"
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct PaperFinalIo {
  vec3 weights[MOST_TERMS];  // w_i of the profile, narrow to wide; a channel sums to 1
  uint side;                 // T, texels
  uint slot;                 // of the counters, see unshaded_reads.frag
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::PaperFinalIo) == 104);
#endif
#endif
