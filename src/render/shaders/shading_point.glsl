// SPDX-License-Identifier: MIT
// A point of a surface that is shaded. COMPUTE_SHADING: in compute shaders, whose points bring their
// derivatives.
#ifndef DERMIS_SHADING_POINT_GLSL
#define DERMIS_SHADING_POINT_GLSL
struct ShadingPoint {
  vec3 position_m;
  vec3 shadow_m;  // where shadows are looked up: position_m, but not below the skin of a fold
  vec3 normal;    // interpolated, unit
  float bulge_m;  // bulge_at() along this normal
  vec4 tangent;
  vec2 uv0, uv1;
  vec4 colour;
#ifdef COMPUTE_SHADING
  vec4 uv_dx, uv_dy;  // of both sets of texture coordinates, per pixel (or texel of a light map)
#endif
};

#ifndef COMPUTE_SHADING
#include "render/shaders/bulge.glsl"

// Returns the point of a fragment, from what is interpolated. plane_m: plane_distance(); uv: both sets; side:
// 1, or -1 where the back of the surface is seen.
ShadingPoint drawn_point(vec3 position_m, vec3 normal, float plane_m, vec4 tangent, vec4 uv, vec4 colour,
                         float side) {
  return ShadingPoint(position_m, position_m, side * normalize(normal),
                      side * bulge_at(position_m, normal, plane_m), tangent, uv.xy, uv.zw, colour);
}
#endif
#endif
