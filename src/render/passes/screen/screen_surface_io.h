// SPDX-License-Identifier: MIT
// The skin of each pixel, for techniques in screen space:
// render/passes/screen/screen_surface.h.
#ifndef DERMIS_PASSES_SCREEN_SURFACE_IO_H
#define DERMIS_PASSES_SCREEN_SURFACE_IO_H
#include "render/shared/types.h"

// A surface: head + 1 in the upper 12 bits, 0 where no skin is; below, its normal in octahedral coordinates
// of 10 bits each.
#define SURFACE_NORMAL_BITS 20
#define MOST_SURFACE_HEADS 4095
// Numbers of skin meshes are stored less this, so that half floats hold all exactly.
#define SURFACE_MESH_MIDDLE 2048
#define MOST_SURFACE_MESHES 4096

DERMIS_IO_BEGIN
// Of one skin mesh of one head.
struct SplitIo {
  vec3 blurred;               // share of the light that is blurred; the rest is lit at the pixel
  float mm_per_unit;          // mm of the asset per metre of the world
  float mesh;                 // of the plan, less SURFACE_MESH_MIDDLE
  uint head;                  // of the plan
  uint first_part, end_part;  // of the head
};
// Of the picture and its camera.
struct ScreenIo {
  uvec2 extent;                    // of the textures, pixels
  vec2 picture_low, picture_size;  // the part of them that the camera sees, pixels
  uvec2 low, size;  // pixels that hold all heads; an invocation for each. Only these are written
  // A metre across the line of sight, at a distance of 1 m (anywhere if the camera is orthographic), in half
  // widths and half heights of the picture
  float across, up;
};
DERMIS_IO_END
#endif
