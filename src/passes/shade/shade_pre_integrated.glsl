// SPDX-License-Identifier: MIT
// Shades the entries of a part by skin_pre_integrated.glsl. THROUGH: with transmitted light.
#define COMPUTE_SHADING
#include "passes/shade/pre_integrated_io.h"
#include "passes/shade/shade_io.h"
#include "shared/scene_io.h"
#include "passes/listed_entry.glsl"
layout(push_constant, scalar) uniform Push { ShadeIo io; };
layout(binding = 1, scalar) readonly buffer Indices { uint indices[]; };
layout(binding = 19, scalar) readonly buffer Curvature { float curvature[]; };
#include "shaders/skin_vertex.glsl"
#include "shaders/vertex_pull.glsl"
#ifdef THROUGH
layout(binding = 31, scalar) uniform Terms { ThroughTermsIo through_terms_io; };
#define TRANSMISSION
#define transmission through_terms_io.transmission
#endif
#include "passes/shade/skin_pre_integrated.glsl"
const bool mixed = false;
#include "passes/shade/shade_point.glsl"

// Returns coordinates of the normal map per mm of the asset, of a triangle.
float normal_uv_per_mm(uvec3 corners) {
  const VertexIo a = vertex_at(corners.x), b = vertex_at(corners.y), c = vertex_at(corners.z);
  const MapIo map = material.maps[MAP_NORMAL];
  vec2 e = b.uv0 - a.uv0, f = c.uv0 - a.uv0;
  if (map.uv_set != 0u) {
    const vec2 first = vertex_extra(corners.x).uv1;
    e = vertex_extra(corners.y).uv1 - first;
    f = vertex_extra(corners.z).uv1 - first;
  }
  const float turned = map.u_axis.x * map.v_axis.y - map.u_axis.y * map.v_axis.x;
  const vec3 p = world_position(b.position_m) - world_position(a.position_m),
             q = world_position(c.position_m) - world_position(a.position_m);
  const float area_mm2 = length(cross(p, q)) * scatter.mm_per_unit * scatter.mm_per_unit;
  return sqrt(abs((e.x * f.y - e.y * f.x) * turned) / max(area_mm2, 1e-12));
}

vec3 seen_radiance(SeenSkin seen) {
  const float per_mm =
      dot(seen.share, vec3(curvature[seen.corners.x], curvature[seen.corners.y], curvature[seen.corners.z]));
  return skin_pre_integrated(seen.s, seen.on.unwrap, per_mm, normal_uv_per_mm(seen.corners));
}

void main() {
  uint place;
  if (!find_listed(io.part, place)) return;
  zero = list[place] >> 31;  // never set: shared/entries_io.h
  const Entry entry = listed(list[place], io.width, io.first_row);
  vec3 radiance = seen_radiance(seen_skin(entry, 0));
  if (light_samples == 2) radiance = 0.5 * (radiance + seen_radiance(seen_skin(entry, 1)));
  imageStore(entries_of_pixels, entry.at, entry_of(radiance));
}
