// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_ENTRIES_IO_H
#define DERMIS_PASSES_ENTRIES_IO_H
#include "render/passes/pixels/pixel_area_io.h"
#include "render/shared/entries_io.h"
DERMIS_IO_BEGIN
struct EntriesIo {
  PixelAreaIo area;  // that holds all heads
  // Distance along the view, metres: factor / (depth - offset), or factor * depth if the camera is
  // orthographic.
  float offset, factor;
  uint orthographic;
  float pixel;     // side of a pixel: metres per metre of distance, or metres if orthographic
  uint parts;      // of a band
  uint band_rows;  // pixels
};
struct PartRangesIo {
  uint parts;       // of a band
  uint first_part;  // of this band among those of all
};
struct EntryListIo {
  PixelAreaIo area;  // that holds all heads in this band
  uint width;        // of the picture, pixels
  uint first_row;    // of the band, pixels
};
DERMIS_IO_END
#endif
