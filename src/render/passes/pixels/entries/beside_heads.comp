// SPDX-License-Identifier: MIT
// Empties pixels of the picture that no head covers.
#version 460
#include "render/passes/pixels/pixel_area_io.h"
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { PixelAreaIo io; };
layout(binding = 0, rgba16f) uniform writeonly image2D picture;

void main() {
  if (gl_GlobalInvocationID.x >= io.size.x) return;
  imageStore(picture, ivec2(io.low + gl_GlobalInvocationID.xy), vec4(0.0));
}
