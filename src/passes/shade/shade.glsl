// SPDX-License-Identifier: MIT
// Shades the entries of a part: skin_radiance.glsl where the entry's triangle is seen. THROUGH: with
// transmitted light.
#define COMPUTE_SHADING
#include "passes/shade/shade_io.h"
#include "shared/scene_io.h"
#include "passes/listed_entry.glsl"
layout(push_constant, scalar) uniform Push { ShadeIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
#include "shaders/skin_vertex.glsl"
#include "shaders/vertex_pull.glsl"
#ifdef THROUGH
layout(binding = 31, scalar) uniform Terms { ThroughTermsIo through_terms_io; };
#define TERMS
#define TRANSMISSION
#define terms through_terms_io.terms
#define transmission through_terms_io.transmission
#endif
#include "passes/shade/skin_radiance.glsl"

#include "passes/shade/shade_point.glsl"

void main() {
  uint place;
  if (!find_listed(io.part, place)) return;
  zero = list[place] >> 31;  // never set: shared/entries_io.h
  const Entry entry = listed(list[place], io.width, io.first_row);
  const SeenSkin seen = seen_skin(entry, 0);
  vec3 radiance = skin_radiance(seen.s, seen.on, false);
  if (light_samples == 2) {  // also where both are one point: a branch per entry would not save it
    const SeenSkin second = seen_skin(entry, 1);
    radiance = 0.5 * (radiance + skin_radiance(second.s, second.on, true));
  }
  imageStore(entries_of_pixels, entry.at, entry_of(radiance));
}
