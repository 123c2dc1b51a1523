// SPDX-License-Identifier: MIT
// TARGETS: how many targets there are, 1 to 4.
// Variant labels_2.frag: TARGETS=2
// Variant labels_3.frag: TARGETS=3
// Variant labels_4.frag: TARGETS=4
#version 460
#ifndef TARGETS
#define TARGETS 1
#endif

#include "render/shared/scene_io.h"
#include "render/passes/pixels/labels/labels_io.h"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
#include "render/shaders/frame.glsl"
layout(binding = 8) uniform sampler2D map_base_colour;
#include "render/shaders/cut_out.glsl"

layout(constant_id = 0) const bool skin = false;
layout(constant_id = 2) const uint labels = 0u;  // LABEL_... bits
layout(push_constant, scalar) uniform Push { LabelsIo io; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_colour;
layout(location = 4) in vec2 in_part;  // distance inside nose and ear
layout(location = 5) in vec4 in_clip;
layout(location = 6) in vec4 in_clip_before;
layout(location = 7) in vec4 in_body;  // unwrap, thickness in mm, how far on the left
layout(location = 8) in vec4 in_face;  // LabelVertexIo
layout(location = 9) flat in uint in_kind;
layout(location = 0) out uvec4 out_words_0;  // of the labels that are drawn
#if TARGETS > 1
layout(location = 1) out uvec4 out_words_1;
#endif
#if TARGETS > 2
layout(location = 2) out uvec4 out_words_2;
#endif
#if TARGETS > 3
layout(location = 3) out uvec4 out_words_3;
#endif

// As ids_cut_out.frag tests skin, and surface.frag all else: from the levels of the map.
bool is_cut_in_picture() {
  if (skin) return is_cut(in_uv, in_colour);
  return material.base_colour.a * in_colour.a * texture(map_base_colour, alpha_uv(in_uv)).a <
         material.alpha_cutoff;
}

uint region() {
  if (!skin) return 0u;
  return in_part.x > 0.0 ? LABEL_REGION_NOSE : in_part.y > 0.0 ? LABEL_REGION_EAR : LABEL_REGION_OTHER_SKIN;
}

uint part() {
  if (!skin) return in_kind;
  if (in_part.x > 0.0) return LABEL_PART_NOSE;
  if (in_part.y > 0.0) return LABEL_PART_RIGHT_EAR + (in_body.w >= 0.0 ? 1u : 0u);
  if (in_face.z > 0.0) return LABEL_PART_MOUTH;
  if (in_face.x > 0.0) return in_face.y > 0.0 ? LABEL_PART_UPPER_LIP : LABEL_PART_LOWER_LIP;
  return in_face.w > 0.0 ? LABEL_PART_NECK : LABEL_PART_FACE;
}

// From where the point was in the frame before to where it is, pixels, y down; infinity if it lay behind the
// camera. GPUs interpolate equal values to results that differ in the last bits: so little is no motion.
vec2 motion() {
  if (in_clip_before.w <= 0.0) return vec2(uintBitsToFloat(0x7f800000u));
  precise const vec2 now = in_clip.xy / in_clip.w, then = in_clip_before.xy / in_clip_before.w;
  const float rounding = exp2(-21.0);
  vec2 moved = now - then;
  moved = mix(moved, vec2(0.0), lessThan(abs(moved), vec2(rounding)));
  return moved * vec2(0.5, -0.5) * io.size;  // y of a clip points up
}

// The places are known when the shader is compiled: no array remains.
uint words[16];
int used = 0;

bool draws(uint label) { return (labels & label) != 0u; }
void put(uint word) { words[used++] = word; }
void put(float value) { put(floatBitsToUint(value)); }
void put(vec2 value) {
  put(value.x);
  put(value.y);
}
void put(vec3 value) {
  put(value.xy);
  put(value.z);
}
uvec4 four_words(int target) {
  const int i = 4 * target;
  return uvec4(words[i], words[i + 1], words[i + 2], words[i + 3]);
}

void main() {
  if (cut_out && is_cut_in_picture()) discard;

  const float len = length(in_normal);
  const vec3 normal = (gl_FrontFacing ? in_normal : -in_normal) / max(len, 1e-30);
  if (draws(LABEL_NORMAL)) put(normal);
  if (draws(LABEL_UV)) put(in_uv.xy);
  if (draws(LABEL_MOTION)) put(motion());
  if (draws(LABEL_UNWRAP)) put(in_body.xy);
  if (draws(LABEL_INSTANCE)) put(io.instance);
  if (draws(LABEL_MATERIAL)) put(io.material);
  if (draws(LABEL_DEPTH)) put(dot(in_position_m - frame.camera.eye_m, frame.camera.direction));
  if (draws(LABEL_SKIN_MESH)) put(io.skin_mesh);
  if (draws(LABEL_THICKNESS)) put(in_body.z);
  if (draws(LABEL_PART)) put(part());
  if (draws(LABEL_REGION)) put(region());

  out_words_0 = four_words(0);
#if TARGETS > 1
  out_words_1 = four_words(1);
#endif
#if TARGETS > 2
  out_words_2 = four_words(2);
#endif
#if TARGETS > 3
  out_words_3 = four_words(3);
#endif
}
