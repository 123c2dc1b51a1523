// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_RESTORE_SKIN_IO_H
#define DERMIS_PASSES_RESTORE_SKIN_IO_H
#include "passes/screen_surface_io.h"
#define RESTORE_DEPTH_MM 1.5  // sigma: light does not come from pixels that are further off the tangent plane
#endif
