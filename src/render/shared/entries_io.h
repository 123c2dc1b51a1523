// SPDX-License-Identifier: MIT
// Skin that a picture shows, before it is shaded: an id per sample, an entry for
// each surface of a pixel, and the entries sorted by part. A part is a run of triangles of one material of a
// skin mesh of a head; a run that is longer than ids can number is several parts.
#ifndef DERMIS_SHARED_ENTRIES_IO_H
#define DERMIS_SHARED_ENTRIES_IO_H
#include "render/shared/types.h"

// An id: part + 1 in the upper bits, the triangle of the part in the lower. 0 is the background.
#define ID_TRIANGLE_BITS 16
#define MOST_PARTS 0xFFFF  // of a frame

// A picture is listed in bands of rows. The entries of a band, 16 bytes per pixel, and the ranges of all
// parts fit in a storage buffer of every device, 128 MiB.
#define MOST_BAND_PIXELS 0x7F0000

// A pixel has at most as many entries as samples: four. A word per pixel holds the samples of each, as bits,
// four per entry, and above them the part of the first.
#define SAMPLES_BITS 16
// An entry of a list: a pixel of its band, row by row, above it which of its entries, and above that its
// samples as bits.
#define PIXEL_BITS 23
#define LISTED_SAMPLES_SHIFT 25

DERMIS_IO_BEGIN

// One for each part of each band.
struct PartIo {
  uint groups[3];  // VkDispatchIndirectCommand of its entries
  uint count;      // of its entries
};

// Of a list, before its entries: one for each part.
struct PartRangeIo {
  uint first, count;  // of its entries: words of the list
};

// Entries of a workgroup; workgroups in x of an indirect dispatch, because all devices allow 65535.
#define ENTRY_GROUP 64
#define ENTRY_ROW 32768

DERMIS_IO_END

#ifdef __cplusplus
static_assert(sizeof(dermis::io::PartIo) == 16);
static_assert(sizeof(dermis::io::PartRangeIo) == 8);
#endif
#endif
