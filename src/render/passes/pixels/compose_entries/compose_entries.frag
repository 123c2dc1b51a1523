// SPDX-License-Identifier: MIT
// The light and the depth of one sample. SINGLE: a pixel has no others.
// Variant compose_entries_single.frag: SINGLE
#version 460
#include "render/passes/pixels/compose_entries/compose_entries_io.h"
#include "render/passes/pixels/shaded_entry.glsl"
layout(push_constant, scalar) uniform Push { ComposeEntriesIo io; };
#ifndef SINGLE
layout(binding = 0) uniform sampler2DMS ids;
layout(binding = 1) uniform sampler2DMS depths;
#else
layout(binding = 0) uniform sampler2D ids;
layout(binding = 1) uniform sampler2D depths;
#endif
layout(binding = 2, r32ui) uniform readonly uimage2D samples_of_pixels;
layout(binding = 3, rg32ui) uniform readonly uimage2DArray entries_of_pixels;
layout(location = 0) flat in int in_sample;  // the level of a texture that has one sample
layout(location = 0) out vec4 out_radiance;

void main() {
  const ivec2 at = ivec2(gl_FragCoord.xy);
  // The background has no part, and is beyond all.
  const uint part = (packUnorm4x8(texelFetch(ids, at, in_sample)) >> ID_TRIANGLE_BITS) - 1u;
  if (part - io.first_part >= io.parts) discard;

  // Entries have four bits each.
  const uint samples = samples_in(imageLoad(samples_of_pixels, at).x);
  const int entry = findLSB(samples >> in_sample & 0x1111u) / 4;
  out_radiance = vec4(radiance_of(imageLoad(entries_of_pixels, ivec3(at, entry)).xy), 1.0);
  gl_FragDepth = texelFetch(depths, at, in_sample).x;
#ifndef SINGLE
  gl_SampleMask[0] = 1 << in_sample;
#endif
}
