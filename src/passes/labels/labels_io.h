// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_LABELS_IO_H
#define DERMIS_PASSES_LABELS_IO_H
#include "shared/instance_io.h"
#include "shared/types.h"
DERMIS_IO_BEGIN
struct LabelsIo {
  uint instance;   // its label: 1 + its number
  uint material;   // likewise
  uint skin_mesh;  // likewise, of its asset; 0: no skin
  vec2 size;       // of the picture, pixels
};

// How an instance stood in the frame before.
struct LabelsBeforeIo {
  mat4 clip_from_world;  // of that frame's camera
  InstanceIo instance;
  uint moved;  // 1: its vertices were elsewhere
};

// Of a vertex of skin.
struct LabelVertexIo {
  vec2 part;  // how far inside nose and ear
  float thickness_mm;
};

// What the pass writes per pixel; zeros where nothing is, but an infinite depth.
struct LabelSurfaceIo {
  vec3 normal;    // unit, world, of the side that is seen
  float depth_m;  // along the axis of the camera
};
struct LabelNamesIo {
  uint instance;
  uint material_and_region;  // the region in the uppermost byte
  vec2 uv;                   // the bits of floats
};
struct LabelBodyIo {
  vec2 unwrap;
  float thickness_mm;
  float skin_mesh;  // a whole number
};
DERMIS_IO_END

#define LABEL_REGION_SHIFT 24
#define LABEL_REGION_NOSE 1u
#define LABEL_REGION_EAR 2u
#define LABEL_REGION_OTHER_SKIN 3u

#ifdef __cplusplus
static_assert(sizeof(dermis::io::LabelSurfaceIo) == 16);
static_assert(sizeof(dermis::io::LabelNamesIo) == 16);
static_assert(sizeof(dermis::io::LabelBodyIo) == 16);
#endif
#endif
