// SPDX-License-Identifier: MIT
// Writes the planes of the blended layer, which label_planes.comp has left out.
#version 460
#include "render/passes/pixels/labels/front_planes_io.h"
#include "render/passes/pixels/labels/labels_io.h"
layout(local_size_x = 16, local_size_y = 16) in;
layout(push_constant, scalar) uniform Push { FrontPlanesIo io; };
layout(constant_id = 0) const uint labels = 0u;  // LABEL_... bits
layout(binding = 0) uniform sampler2D coverage;
layout(binding = 1) uniform usampler2D parts;
layout(binding = 2, scalar) writeonly buffer Planes { uint planes[]; };

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, io.size))) return;
  const uint pixel = at.y * io.size.x + at.x;
  const ivec2 p = ivec2(at);
  if ((labels & LABEL_FRONT) != 0u)
    planes[io.first_coverage + pixel] = floatBitsToUint(texelFetch(coverage, p, 0).r);
  if ((labels & LABEL_FRONT_PART) != 0u) planes[io.first_part + pixel] = texelFetch(parts, p, 0).r;
}
