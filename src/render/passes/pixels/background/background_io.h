// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_BACKGROUND_IO_H
#define DERMIS_PASSES_BACKGROUND_IO_H
#include "render/shared/types.h"
// The values of specialisation constant `kind`: those of passes::Behind.
#define BEHIND_STUDIO 1u
#define BEHIND_ENVIRONMENT 2u
DERMIS_IO_BEGIN
struct BackgroundIo {
  mat4 world_from_clip;
  uint has_picture;  // of the environment
};
DERMIS_IO_END
#endif
