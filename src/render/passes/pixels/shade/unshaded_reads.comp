// SPDX-License-Identifier: MIT
// For each point at which an entry is shaded: counts the read if a texel that its bilinear read weighs holds
// no light. Bilinear units resolve at most 1/256 of a texel: smaller weights count as none. Reads of cut-out
// skin skip missing texels: of these, reads that find nothing count.
#version 460
#include "render/passes/pixels/shade/listed_entry.glsl"
layout(binding = 41, scalar) buffer Counters { uint counters[]; };
layout(constant_id = 24) const int counter = 0;
#include "render/passes/pixels/shade/skin_radiance.glsl"
#include "render/passes/pixels/shade/shade_point.glsl"

bool is_unshaded(sampler2D light, SeenSkin seen) {
  vec2 from = vec2(0.0);
  if (shape_aware)
    from = exit_offset(seen.on.along, seen.on.shape.w, seen.s.normal, view_vector(seen.s.position_m));
  const vec2 at = light_point(seen.on.unwrap + from) - 0.5;
  const ivec2 corner = ivec2(floor(at));
  const vec2 f = at - vec2(corner);
  bool unlit = false, lit = false;
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y);
    if (weight <= 1.0 / 256.0) continue;
    const ivec2 p = min(corner + d, ivec2(map_origin() + io.side - 1u));
    const bool is_lit = texelFetch(light, p, 0) != vec4(0.0);
    unlit = unlit || !is_lit;
    lit = lit || is_lit;
  }
  return cut_out ? !lit : unlit;
}

bool reads_unshaded(SeenSkin seen) {
  bool found = false;
  if (is_read(0) && mapped_weight(0, seen.on) != vec3(0.0)) found = found || is_unshaded(light_0, seen);
  if (is_read(1) && mapped_weight(1, seen.on) != vec3(0.0)) found = found || is_unshaded(light_1, seen);
  if (is_read(2) && mapped_weight(2, seen.on) != vec3(0.0)) found = found || is_unshaded(light_2, seen);
  if (is_read(3) && mapped_weight(3, seen.on) != vec3(0.0)) found = found || is_unshaded(light_3, seen);
  if (is_read(4) && mapped_weight(4, seen.on) != vec3(0.0)) found = found || is_unshaded(light_4, seen);
  if (is_read(5) && mapped_weight(5, seen.on) != vec3(0.0)) found = found || is_unshaded(light_5, seen);
  if (is_read(6) && mapped_weight(6, seen.on) != vec3(0.0)) found = found || is_unshaded(light_6, seen);
  if (is_read(7) && mapped_weight(7, seen.on) != vec3(0.0)) found = found || is_unshaded(light_7, seen);
  return found;
}

void main() {
  Entry entry;
  if (!find_entry(entry)) return;
  if (reads_unshaded(seen_skin(entry, 0))) atomicAdd(counters[counter], 1u);
  if (has_two_points(entry) && reads_unshaded(seen_skin(entry, 1))) atomicAdd(counters[counter], 1u);
}
