// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_SHADE_IO_H
#define DERMIS_PASSES_SHADE_IO_H
#include "passes/final_pass/final_pass_io.h"
#include "shared/transmission_io.h"
DERMIS_IO_BEGIN
struct ShadeIo {
  FinalPassIo look;  // slot: the part
  uint width;        // of the targets, pixels
};
// One buffer in place of two: devices may have no more than 32 bindings.
struct ThroughTermsIo {
  SkinTermsIo terms;
  TransmissionIo transmission;  // of all terms
};
DERMIS_IO_END
#ifdef __cplusplus
static_assert(sizeof(dermis::io::ShadeIo) == 120);
#endif
#endif
