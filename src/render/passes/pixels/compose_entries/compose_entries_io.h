// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_COMPOSE_ENTRIES_IO_H
#define DERMIS_PASSES_COMPOSE_ENTRIES_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct ComposeEntriesIo {
  uint first_part, parts;  // those that are shaded
};
DERMIS_IO_END
#endif
