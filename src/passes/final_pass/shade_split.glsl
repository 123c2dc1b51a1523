// SPDX-License-Identifier: MIT
// Shades the entries of a part in parts, for techniques in screen space: what is blurred goes to images, what
// is not to the entries. THROUGH: with transmitted light.
#define COMPUTE_SHADING
#include "passes/final_pass/shade_io.h"
#include "shared/entries_io.h"
#include "shared/scene_io.h"
layout(local_size_x = ENTRY_GROUP) in;
layout(push_constant, scalar) uniform Push { ShadeIo shade; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 25, scalar) buffer Entries { EntryIo entries[]; };
#include "shaders/skin_vertex.glsl"
#include "shaders/vertex_pull.glsl"
#include "passes/screen_surface.glsl"
#ifdef THROUGH
layout(binding = 31, scalar) uniform Terms { ThroughTermsIo through_terms_io; };
#define TRANSMISSION
#define transmission through_terms_io.transmission
#endif
#include "passes/final_pass/skin_split.glsl"
const bool coarse = false;
#include "passes/final_pass/shade_point.glsl"
layout(binding = 14, rgba16f) uniform writeonly image2D light_of_skin;
layout(binding = 15, r32f) uniform writeonly image2D depth_of_skin;
layout(binding = 16, r32ui) uniform writeonly uimage2D surface_of_skin;
layout(binding = 17, rgba16f) uniform writeonly image2DArray leaving_skin;
layout(binding = 18, scalar) uniform Split { SplitIo split; };
layout(binding = 19, scalar) readonly buffer Pixels { PixelIo pixels[]; };

void main() {
  const uint number =
      (gl_WorkGroupID.y * ENTRY_ROW + gl_WorkGroupID.x) * ENTRY_GROUP + gl_LocalInvocationIndex;
  const EntryIo range = entries[shade.look.slot];  // a PartRangeIo
  if (number >= range.y) return;
  const uint place = range.x + number;
  const EntryIo entry = entries[place];
  zero = entry.y >> 31;  // never set: RANK_BITS and four samples
  const SeenSkin seen = seen_skin(entry);
  SplitSkin skin = skin_split(seen.s, seen.on.unwrap, split.blurred);

  // The two entries of a pixel have no sample in common, so samples tell which of them this is.
  const uint pixel = entry.y & (1u << RANK_BITS) - 1u;
  const ivec2 at = ivec2(pixel % shade.extent.x, pixel / shade.extent.x);
  const PixelIo shown = pixels[pixel];
  const bool is_first = (shown.rank_first >> RANK_BITS & 15u) == entry.y >> RANK_BITS;
  if (is_first) {
    const float depth_m = dot(seen.s.position_m - frame.camera.eye_m, frame.camera.direction);
    imageStore(light_of_skin, at, vec4(skin.light, 1.0));
    imageStore(depth_of_skin, at, vec4(depth_m * split.mm_per_unit));
    imageStore(surface_of_skin, at, uvec4(packed_surface(split.head, seen.s.normal)));
  } else {
    // The light of another head is not this head's: there is none of its own in this pixel.
    const uint part = (shown.first >> ID_TRIANGLE_BITS) - 1u;
    if (part < split.first_part || part >= split.end_part) {
      skin.rest = storable(skin.rest + skin.leaving * skin.light);
      skin.leaving = vec3(0.0);
    }
  }
  imageStore(leaving_skin, ivec3(at, is_first ? 0 : 1), vec4(round_to_half(skin.leaving), split.mesh));
  entries[place] = EntryIo(packHalf2x16(skin.rest.xy), packHalf2x16(vec2(skin.rest.z, 0.0)));
}
