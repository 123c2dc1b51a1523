// SPDX-License-Identifier: MIT
// The entries that a dispatch shades: those of one part in a band, an invocation for each. Below, where their
// skin lies on its light map. The shaders that shade them begin with this and end with shade_point.glsl.
// THROUGH: with transmitted light.
#define COMPUTE_SHADING
#include "render/passes/pixels/shade/shade_io.h"
#include "render/shared/scene_io.h"
#include "render/passes/pixels/shaded_entry.glsl"
layout(push_constant, scalar) uniform Push { ShadeIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/vertex_pull.glsl"
#ifdef THROUGH
layout(binding = 31, scalar) uniform Terms { ThroughTermsIo through_terms_io; };
#define TERMS
#define TRANSMISSION
#define terms through_terms_io.terms
#define transmission through_terms_io.transmission
#endif
layout(local_size_x = ENTRY_GROUP) in;
layout(binding = 25, scalar) readonly buffer List { uint list[]; };
layout(binding = 38, rg32ui) uniform uimage2DArray entries_of_pixels;

struct Entry {
  ivec3 at;              // pixel, and which of its entries
  uint triangle;         // of its part
  uint samples;          // as bits
  uint second_triangle;  // that of the last sample, if this is the only entry of the pixel
};

// Returns whether a surface covers all of its pixel.
bool is_whole(Entry entry, bool multisampled) { return !multisampled || entry.samples == 15u; }

// Returns whether there is an entry of the part for this invocation, and its place in the list.
bool find_listed(out uint place) {
  const uint number =
      (gl_WorkGroupID.y * ENTRY_ROW + gl_WorkGroupID.x) * ENTRY_GROUP + gl_LocalInvocationIndex;
  place = list[2u * io.part] + number;  // a PartRangeIo
  return number < list[2u * io.part + 1u];
}

uint triangle_at(ivec3 at) { return imageLoad(entries_of_pixels, at).x & (1u << ID_TRIANGLE_BITS) - 1u; }

Entry listed(uint word) {
  const uint pixel = word & (1u << PIXEL_BITS) - 1u;
  const ivec3 at = ivec3(pixel % io.width, io.first_row + pixel / io.width, word >> PIXEL_BITS & 3u);
  const uint samples = word >> LISTED_SAMPLES_SHIFT & 15u, triangle = triangle_at(at);
  return Entry(at, triangle, samples, samples == 15u ? triangle_at(at + ivec3(0, 0, 1)) : triangle);
}

layout(constant_id = 18) const bool shape_aware = false;  // the profile has laws of shape

// Change of unwrap coordinates over a triangle, per metre of the world.
struct AlongSkin {
  vec3 u, v;
};

AlongSkin along_triangle(vec3 a, vec3 b, vec3 c, vec2 unwrap_a, vec2 unwrap_b, vec2 unwrap_c) {
  const vec3 ab = b - a, ac = c - a, across = cross(ab, ac);
  const float area2 = max(dot(across, across), 1e-30);
  const vec3 of_b = cross(ac, across) / area2, of_c = cross(across, ab) / area2;
  const vec2 to_b = unwrap_b - unwrap_a, to_c = unwrap_c - unwrap_a;
  return AlongSkin(to_b.x * of_b + to_c.x * of_c, to_b.y * of_b + to_c.y * of_c);
}

// The place of skin on its light map.
struct OnMap {
  vec2 unwrap;      // in its triangle
  float uv_per_mm;  // texture coordinates
  vec4 shape;       // body_shape()
  AlongSkin along;
};
