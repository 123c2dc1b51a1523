// SPDX-License-Identifier: MIT
// For each fragment that the final pass shades: counts the read if a texel that its bilinear read weighs
// holds no light. Bilinear units resolve at most 1/256 of a texel: smaller weights count as none. Reads of
// cut-out skin skip missing texels: of these, reads that find nothing count.
#version 460
#include "shared/scene_io.h"
#include "passes/final_pass/final_pass_io.h"
layout(early_fragment_tests) in;
layout(push_constant, scalar) uniform Push { FinalPassIo io; };
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
layout(binding = 8) uniform sampler2D map_base_colour;
#include "shaders/cut_out.glsl"
layout(binding = 14) uniform sampler2D light_0;
layout(binding = 15, scalar) buffer Counters { uint counters[]; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 5) centroid in vec2 in_unwrap;
layout(location = 8) in float in_uv_per_mm;
layout(location = 9) in vec4 in_shape;
#include "passes/final_pass/map_share.glsl"
#include "passes/final_pass/within_triangle.glsl"
#include "passes/final_pass/light_point.glsl"
#include "passes/final_pass/along_skin.glsl"
#include "shaders/frame.glsl"
#include "shaders/switches.glsl"
#include "shaders/view_vector.glsl"
#include "passes/final_pass/exit_offset.glsl"
layout(location = 10) flat in AlongSkin in_along;

void main() {
  if (cut_out && is_cut(in_uv, in_colour)) return;
  if (map_share(terms.widest_mm, in_uv_per_mm) == 0.0) return;  // nothing is read from the map
  vec2 from = vec2(0.0);
  if (shape_aware) {
    const vec3 n = normalize(in_normal);
    from = exit_offset(in_along, in_shape.w, gl_FrontFacing ? n : -n, view_vector(in_position_m));
  }
  const vec2 at = light_point(within_triangle(in_unwrap) + from) - 0.5;
  const ivec2 corner = ivec2(floor(at));
  const vec2 f = at - vec2(corner);
  bool unshaded = false, shaded = false;
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y);
    const ivec2 p = min(corner + d, ivec2(io.map_origin + io.map_side - 1u));
    const bool lit = texelFetch(light_0, p, 0) != vec4(0.0);
    unshaded = unshaded || (weight > 1.0 / 256.0 && !lit);
    shaded = shaded || (weight > 1.0 / 256.0 && lit);
  }
  if (cut_out ? !shaded : unshaded) atomicAdd(counters[io.slot], 1u);
}
