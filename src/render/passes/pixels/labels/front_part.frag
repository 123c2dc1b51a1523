// SPDX-License-Identifier: MIT
// The part that stands nearest, of those that cover a half or more.
#version 460
#include "render/passes/pixels/labels/front_alpha.glsl"
layout(location = 9) flat in uint in_kind;
layout(location = 0) out uint out_part;

void main() {
  if (front_alpha() < 0.5) discard;
  out_part = in_kind;
}
