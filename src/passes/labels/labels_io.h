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

// An instance as it stood in the frame before.
struct LabelsBeforeIo {
  mat4 clip_from_world;  // of that frame's camera
  InstanceIo instance;
  uint moved;  // 1: its vertices were elsewhere
};

// Of a vertex of skin.
struct LabelVertexIo {
  vec2 part;  // distance inside nose and ear
  float thickness_mm;
};

DERMIS_IO_END

// Bits of specialisation constant `labels`. The pass writes the words of those that are set one after the
// other, in this order, four to a target, floats as their bits. Zeros where nothing is, but an infinite
// depth.
#define LABEL_NORMAL 1u     // 3 words: unit, world, of the side that is seen
#define LABEL_UV 2u         // 2
#define LABEL_MOTION 4u     // 2: pixels since the frame before, y down
#define LABEL_UNWRAP 8u     // 2
#define LABEL_INSTANCE 16u  // 1, like all that follow
#define LABEL_MATERIAL 32u
#define LABEL_DEPTH 64u  // m, along the axis of the camera
#define LABEL_SKIN_MESH 128u
#define LABEL_THICKNESS 256u  // mm
#define LABEL_REGION 512u
#define LABEL_COUNT 10
#define LABEL_MOST_WORDS 15

#define LABEL_REGION_NOSE 1u
#define LABEL_REGION_EAR 2u
#define LABEL_REGION_OTHER_SKIN 3u
#endif
