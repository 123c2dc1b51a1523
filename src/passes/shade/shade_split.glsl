// SPDX-License-Identifier: MIT
// Shades the entries of a part in parts, for techniques in screen space: what is blurred goes to images, what
// is not to the entries. THROUGH: with transmitted light.
#define COMPUTE_SHADING
#include "passes/shade/shade_io.h"
#include "shared/scene_io.h"
#include "passes/listed_entry.glsl"
layout(push_constant, scalar) uniform Push { ShadeIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
#include "shaders/skin_vertex.glsl"
#include "shaders/vertex_pull.glsl"
#include "passes/screen_surface.glsl"
#ifdef THROUGH
layout(binding = 31, scalar) uniform Terms { ThroughTermsIo through_terms_io; };
#define TRANSMISSION
#define transmission through_terms_io.transmission
#endif
#include "passes/shade/skin_split.glsl"
const bool mixed = false;
#include "passes/shade/shade_point.glsl"
layout(binding = 14, rgba16f) uniform writeonly image2D light_of_skin;
layout(binding = 15, r32f) uniform writeonly image2D depth_of_skin;
layout(binding = 16, r32ui) uniform writeonly uimage2D surface_of_skin;
layout(binding = 17, rgba16f) uniform writeonly image2DArray leaving_skin;
layout(binding = 18, scalar) uniform Split { SplitIo split; };
layout(binding = 19, r32ui) uniform readonly uimage2D samples_of_pixels;

void main() {
  uint place;
  if (!find_listed(io.part, place)) return;
  zero = list[place] >> 31;  // never set: shared/entries_io.h
  const Entry entry = listed(list[place], io.width, io.first_row);
  const SeenSkin seen = seen_skin(entry, 0);
  SplitSkin skin = skin_split(seen.s, seen.on.unwrap, split.blurred);
  vec3 middle_m = seen.s.position_m;
  if (light_samples == 2) {
    const SeenSkin second = seen_skin(entry, 1);
    skin = mean_of(skin, skin_split(second.s, second.on.unwrap, split.blurred));
    middle_m = 0.5 * (middle_m + second.s.position_m);
  }

  const ivec2 at = entry.at.xy;
  if (entry.at.z == 0) {
    const float depth_m = dot(middle_m - frame.camera.eye_m, frame.camera.direction);
    imageStore(light_of_skin, at, vec4(skin.light, 1.0));
    imageStore(depth_of_skin, at, vec4(depth_m * split.mm_per_unit));
    imageStore(surface_of_skin, at, uvec4(packed_surface(split.head, seen.s.normal)));
  } else {
    // The light of another head is not this head's: there is none of its own in this pixel.
    const uint part = imageLoad(samples_of_pixels, at).x >> SAMPLES_BITS;
    if (part < split.first_part || part >= split.end_part) {
      skin.rest = storable(skin.rest + skin.leaving * skin.light);
      skin.leaving = vec3(0.0);
    }
  }
  imageStore(leaving_skin, entry.at, vec4(round_to_half(skin.leaving), split.mesh));
  imageStore(entries_of_pixels, entry.at, entry_of(skin.rest));
}
