// SPDX-License-Identifier: MIT
#ifndef DERMIS_PASSES_LABELS_IO_H
#define DERMIS_PASSES_LABELS_IO_H
#include "render/shared/scene_io.h"
#include "render/shared/types.h"
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
  SimilarityIo world_from_asset;
  uint moved;  // 1: its vertices were elsewhere
};

// Of a vertex of skin; of all else, `kind` alone counts.
struct LabelVertexIo {
  vec2 part;  // distance inside nose and ear
  float thickness_mm;
  float left;  // distance on the person's left
  vec4 face;   // distances inside the lips, above their parting, behind them, below the jaw
  uint kind;   // LABEL_PART_... of what is no skin
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
#define LABEL_PART 512u
// Of the layer of blended parts, which passes of their own draw: no words of this one.
#define LABEL_FRONT 1024u       // its cover, 0 to 1
#define LABEL_FRONT_PART 2048u  // of its nearest part that covers a half or more
#define LABEL_REGION 4096u
#define LABEL_COUNT 13
#define LABEL_MOST_WORDS 16  // of this pass
#define LABEL_FRONT_LAYER (LABEL_FRONT | LABEL_FRONT_PART)

#define LABEL_REGION_NOSE 1u
#define LABEL_REGION_EAR 2u
#define LABEL_REGION_OTHER_SKIN 3u

#define LABEL_PART_FACE 1u
#define LABEL_PART_NOSE 2u
#define LABEL_PART_RIGHT_EYE 3u  // the person's right; what is left has one more
#define LABEL_PART_RIGHT_BROW 5u
#define LABEL_PART_RIGHT_EAR 7u
#define LABEL_PART_MOUTH 9u
#define LABEL_PART_UPPER_LIP 10u
#define LABEL_PART_LOWER_LIP 11u
#define LABEL_PART_NECK 12u
#define LABEL_PART_HAIR 13u
#define LABEL_PART_LASHES 14u
#define LABEL_PART_OTHER 15u
#endif
