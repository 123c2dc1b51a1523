// SPDX-License-Identifier: MIT
// What of the skin a picture shows, before it is shaded: an id per sample, at most two entries per pixel, and
// the entries sorted by part. A part is a run of triangles of one material of a skin mesh of a head.
#ifndef DERMIS_SHARED_ENTRIES_IO_H
#define DERMIS_SHARED_ENTRIES_IO_H
#include "shared/types.h"

// An id: part + 1 in the upper bits, the triangle of its mesh in the lower. 0 is the background.
#define ID_TRIANGLE_BITS 20
#define MOST_PARTS 4095          // of a frame: 12 bits
#define MOST_TRIANGLES 0x100000  // of a skin mesh
// So that the entries of all pixels fit in the storage buffers of every device: 128 MiB.
#define MOST_SHADED_PIXELS 0x800000
#define RANK_BITS 24

DERMIS_IO_BEGIN

// The entries of a pixel. A rank is the number of an entry among those of its part.
struct PixelIo {
  uint first, second;  // ids; those without a sample are not set
  uint rank_first;     // and, above RANK_BITS, the samples of the first entry and of the second, as bits
  uint rank_second;
};

// One for each part.
struct PartIo {
  uint groups[3];  // VkDispatchIndirectCommand of its entries
  uint count;      // of its entries
};

// Of the list, before its entries: one for each part.
struct PartRangeIo {
  uint first, count;  // of its entries, in the list
};

// An entry of the list: before it is shaded its id, its pixel, and above RANK_BITS its samples as bits;
// afterwards its radiance as three half floats.
struct EntryIo {
  uint x, y;
};

// Entries of a workgroup; workgroups in x of an indirect dispatch, because all devices allow 65535.
#define ENTRY_GROUP 64
#define ENTRY_ROW 32768

DERMIS_IO_END

#ifdef __cplusplus
static_assert(sizeof(dermis::io::PixelIo) == 16);
static_assert(sizeof(dermis::io::PartIo) == 16);
#endif
#endif
