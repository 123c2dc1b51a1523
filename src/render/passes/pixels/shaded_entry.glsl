// SPDX-License-Identifier: MIT
// Content of an entry of a pixel: before it is shaded its id and its rank among
// those of its part; afterwards its radiance as three half floats.
#include "render/shared/entries_io.h"

// The samples of a pixel's entries, from the word that has the part of the first above them.
uint samples_in(uint word) { return word & (1u << SAMPLES_BITS) - 1u; }

uvec4 entry_of(vec3 radiance) {
  return uvec4(packHalf2x16(radiance.xy), packHalf2x16(vec2(radiance.z, 0.0)), 0u, 0u);
}
vec3 radiance_of(uvec2 entry) { return vec3(unpackHalf2x16(entry.x), unpackHalf2x16(entry.y).x); }
