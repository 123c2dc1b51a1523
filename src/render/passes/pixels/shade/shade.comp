// SPDX-License-Identifier: MIT
// Shades the entries of a part: skin_radiance.glsl where the entry's triangle is seen. THROUGH: with
// transmitted light.
// Variant shade_through.comp: THROUGH
#version 460
#include "render/passes/pixels/shade/listed_entry.glsl"
#include "render/passes/pixels/shade/skin_radiance.glsl"
#include "render/passes/pixels/shade/shade_point.glsl"

void main() {
  Entry entry;
  if (!find_entry(entry)) return;
  const SeenSkin seen = seen_skin(entry, 0);
  vec3 radiance = skin_radiance(seen.s, seen.on, false);
  if (light_samples == 2) {  // also where both are one point: a branch per entry would not save it
    const SeenSkin second = seen_skin(entry, 1);
    radiance = 0.5 * (radiance + skin_radiance(second.s, second.on, true));
  }
  imageStore(entries_of_pixels, entry.at, entry_of(radiance));
}
