// SPDX-License-Identifier: MIT
// Turns pixels that hold several labels into planes that hold one each, as the caller of a session reads
// them, in the order of their bits. The region, the last, has a byte per pixel. front_planes.comp writes
// those of the blended layer.
#version 460
#include "render/passes/pixels/labels/label_planes_io.h"
#include "render/passes/pixels/labels/labels_io.h"
layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push { LabelPlanesIo io; };
layout(constant_id = 0) const uint labels = 0u;  // LABEL_... bits
layout(binding = 0) uniform usampler2D words_0;
layout(binding = 1) uniform usampler2D words_1;
layout(binding = 2) uniform usampler2D words_2;
layout(binding = 3) uniform usampler2D words_3;
layout(binding = 4, scalar) writeonly buffer Planes { uint planes[]; };

uint pixel, pixels;
uint first = 0u;  // word of the next plane
int used = 0;     // words of a pixel so far

uint label_word(ivec2 p, int word) {
  const int target = word / 4, part = word % 4;
  if (target == 0) return texelFetch(words_0, p, 0)[part];
  if (target == 1) return texelFetch(words_1, p, 0)[part];
  if (target == 2) return texelFetch(words_2, p, 0)[part];
  return texelFetch(words_3, p, 0)[part];
}

void copy_label(uint label, int words, ivec2 p) {
  if ((labels & label) == 0u) return;
  for (int i = 0; i < words; ++i) planes[first + uint(words) * pixel + uint(i)] = label_word(p, used + i);
  first += uint(words) * pixels;
  used += words;
}

void leave_plane(uint label) {
  if ((labels & label) != 0u) first += pixels;
}

// The first of four pixels writes the bytes of all.
void copy_regions() {
  if ((labels & LABEL_REGION) == 0u || pixel % 4u != 0u) return;
  uint bytes = 0u;
  for (uint i = 0u; i < 4u && pixel + i < pixels; ++i) {
    const uint at = pixel + i;
    bytes |= label_word(ivec2(at % io.size.x, at / io.size.x), used) << (8u * i);
  }
  planes[first + pixel / 4u] = bytes;
}

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, io.size))) return;
  const ivec2 p = ivec2(at);
  pixel = at.y * io.size.x + at.x;
  pixels = io.size.x * io.size.y;

  copy_label(LABEL_NORMAL, 3, p);
  copy_label(LABEL_UV, 2, p);
  copy_label(LABEL_MOTION, 2, p);
  copy_label(LABEL_UNWRAP, 2, p);
  copy_label(LABEL_INSTANCE, 1, p);
  copy_label(LABEL_MATERIAL, 1, p);
  copy_label(LABEL_DEPTH, 1, p);
  copy_label(LABEL_SKIN_MESH, 1, p);
  copy_label(LABEL_THICKNESS, 1, p);
  copy_label(LABEL_PART, 1, p);
  leave_plane(LABEL_FRONT);
  leave_plane(LABEL_FRONT_PART);
  copy_regions();
}
