// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_IDS_IO_H
#define DERMIS_PASSES_IDS_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
struct IdsIo {
  uint first_id;  // of the part's mesh: that of triangle 0
};
DERMIS_IO_END
#endif
