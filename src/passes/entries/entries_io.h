// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_ENTRIES_IO_H
#define DERMIS_PASSES_ENTRIES_IO_H
#include "shared/entries_io.h"
DERMIS_IO_BEGIN
struct EntriesIo {
  uvec2 low, size;  // pixels that hold all heads; an invocation for each
  uint width;       // of the picture, pixels
  // Distance along the view, metres: factor / (depth - offset), or factor * depth if the camera is
  // orthographic.
  float offset, factor;
  uint orthographic;
  float pixel;  // side of a pixel: metres per metre of distance, or metres if orthographic
};
// Of all lists, and of the picture.
struct EntryListIo {
  uvec2 low, size;  // as above
  uint width;
  uint parts;
};
// Pixels beside those that hold all heads.
struct BesideHeadsIo {
  uvec2 low, size;
};
DERMIS_IO_END
#endif
