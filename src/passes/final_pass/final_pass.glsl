// SPDX-License-Identifier: MIT
// Skin that is drawn: skin_radiance.glsl at each fragment. Alpha 1 marks skin.
#include "passes/final_pass/final_pass_io.h"
#include "shared/scene_io.h"
layout(push_constant, scalar) uniform Push { FinalPassIo io; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
// Centroid: beside a silhouette or a seam the centre of the pixel may be off the triangle, where the map may
// be empty.
layout(location = 5) centroid in vec2 in_unwrap;
layout(location = 8) in float in_uv_per_mm;  // texture coordinates per mm
layout(location = 9) in vec4 in_shape;       // body_shape()
#include "passes/final_pass/skin_radiance.glsl"
layout(location = 10) flat in AlongSkin in_along;
layout(location = 12) in float in_plane_m;  // plane_distance()
layout(location = 0) out vec4 out_radiance;

#include "passes/final_pass/within_triangle.glsl"

void main() {
  const ShadingPoint s = drawn_point(in_position_m, in_normal, in_plane_m, in_tangent, in_uv, in_colour,
                                     gl_FrontFacing ? 1.0 : -1.0);
  const OnMap on = OnMap(within_triangle(in_unwrap), in_uv_per_mm, in_shape, in_along);
  const vec3 radiance = skin_radiance(s, on, false);

  if (cut_out && is_cut(in_uv, in_colour)) discard;
  out_radiance = vec4(radiance, 1.0);
}
