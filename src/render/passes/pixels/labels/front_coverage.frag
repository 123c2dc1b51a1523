// SPDX-License-Identifier: MIT
// Over each other, parts let through the product of what each lets through, in any order.
#version 460
#include "render/passes/pixels/labels/front_alpha.glsl"
layout(location = 0) out vec4 out_coverage;

void main() {
  const float alpha = front_alpha();
  out_coverage = vec4(alpha, 0.0, 0.0, alpha);
}
