// SPDX-License-Identifier: MIT
// Shades the entries of a part: skin_radiance.glsl where the entry's triangle is seen. THROUGH: with
// transmitted light.
#define COMPUTE_SHADING
#include "passes/final_pass/shade_io.h"
#include "shared/entries_io.h"
#include "shared/scene_io.h"
layout(local_size_x = ENTRY_GROUP) in;
layout(push_constant, scalar) uniform Push { ShadeIo shade; };
#define io shade.look
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 25, scalar) buffer Entries { EntryIo entries[]; };
#include "shaders/skin_vertex.glsl"
#include "shaders/vertex_pull.glsl"
#ifdef THROUGH
layout(binding = 31, scalar) uniform Terms { ThroughTermsIo through_terms_io; };
#define TERMS
#define TRANSMISSION
#define terms through_terms_io.terms
#define transmission through_terms_io.transmission
#endif
#include "passes/final_pass/skin_radiance.glsl"

#include "passes/final_pass/shade_point.glsl"

void main() {
  const uint number =
      (gl_WorkGroupID.y * ENTRY_ROW + gl_WorkGroupID.x) * ENTRY_GROUP + gl_LocalInvocationIndex;
  const EntryIo range = entries[io.slot];  // a PartRangeIo
  if (number >= range.y) return;
  const uint place = range.x + number;
  const EntryIo entry = entries[place];
  zero = entry.y >> 31;  // never set: RANK_BITS and four samples
  const SeenSkin seen = seen_skin(entry);
  const vec3 radiance = skin_radiance(seen.s, seen.on);
  entries[place] = EntryIo(packHalf2x16(radiance.xy), packHalf2x16(vec2(radiance.z, 0.0)));
}
