// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_IDS_IO_H
#define DERMIS_PASSES_IDS_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct IdsIo {
  uint first_id;  // that triangle 0 of the mesh would have
};
DERMIS_IO_END
#endif
