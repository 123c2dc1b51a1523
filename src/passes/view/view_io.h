// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_VIEW_IO_H
#define DERMIS_PASSES_VIEW_IO_H
#include "shared/types.h"
DERMIS_IO_BEGIN
#define VIEW_FILMIC 0u
#define VIEW_SRGB 1u
#define VIEW_LINEAR 2u
struct ViewIo {
  uint transform;
};
DERMIS_IO_END
#endif
