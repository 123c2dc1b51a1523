// SPDX-License-Identifier: MIT
#ifndef DERMIS_PUBLISHED_SQUARE_IO_H
#define DERMIS_PUBLISHED_SQUARE_IO_H
#include "render/shared/types.h"
DERMIS_IO_BEGIN
struct SquareIo {
  uint side;  // T, texels
};
DERMIS_IO_END
#endif
