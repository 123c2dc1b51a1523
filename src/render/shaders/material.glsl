// SPDX-License-Identifier: MIT
// A point of a surface that is shaded, and its material's maps there. Needs MaterialIo `material` and
// samplers map_base_colour ... (scene_io.h). COMPUTE_SHADING: in compute shaders, whose points bring their
// derivatives.
#include "render/shaders/switches.glsl"

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

// Returns the unit vector from a point to the camera. Needs frame.glsl.
vec3 view_vector(vec3 position_m) {
  return is_on(frame.camera.orthographic) ? -frame.camera.direction
                                          : normalize(frame.camera.eye_m - position_m);
}

vec2 map_uv(MapIo map, ShadingPoint s) {
  const vec2 uv = map.uv_set == 0u ? s.uv0 : s.uv1;
  return map.u_axis * uv.x + map.v_axis * uv.y + map.offset;
}

// Returns by how much map_uv() changes per pixel (or texel of a light map): along x, along y.
mat2 map_uv_change(MapIo map, ShadingPoint s) {
#ifdef COMPUTE_SHADING
  const vec2 dx = map.uv_set == 0u ? s.uv_dx.xy : s.uv_dx.zw, dy = map.uv_set == 0u ? s.uv_dy.xy : s.uv_dy.zw;
#else
  const vec2 uv = map.uv_set == 0u ? s.uv0 : s.uv1, dx = dFdx(uv), dy = dFdy(uv);
#endif
  return mat2(map.u_axis * dx.x + map.v_axis * dx.y, map.u_axis * dy.x + map.v_axis * dy.y);
}

// Returns a map at the point, filtered over a pixel (or a texel of a light map).
vec4 map_texel(sampler2D texels, MapIo map, ShadingPoint s) {
#ifdef COMPUTE_SHADING
  const mat2 change = map_uv_change(map, s);
  return textureGrad(texels, map_uv(map, s), change[0], change[1]);
#else
  return texture(texels, map_uv(map, s));
#endif
}

// Returns what a normal map holds at the point, in tangent space; not normalised.
vec3 mapped_slope(MapIo map, sampler2D normal_map, ShadingPoint s) {
  vec3 t = map_texel(normal_map, map, s).xyz * 2.0 - 1.0;
  t.xy *= map.scale;
  return t;
}

vec3 from_tangent_space(vec3 t, ShadingPoint s) {
  // MikkTSpace: the bitangent is computed per pixel, and the tangent frame is used as interpolated.
  const vec3 bitangent = cross(s.normal, s.tangent.xyz) * s.tangent.w;
  const vec3 n = s.tangent.xyz * t.x + bitangent * t.y + s.normal * t.z;
  const float length2 = dot(n, n);
  return length2 > 1e-12 ? n * inversesqrt(length2) : s.normal;
}

vec3 mapped_normal(MapIo map, sampler2D normal_map, ShadingPoint s) {
  return is_present(map) ? from_tangent_space(mapped_slope(map, normal_map, s), s) : s.normal;
}

// Relief finer than a texel of the normal map is a tiled map of normals, as near as a pixel shows it. The
// finest furrows of a tile are some texels wide, and a tile that repeats shows only when they merge: the
// relief fades between so many texels per pixel.
const float detail_whole = 2.0, detail_gone = 8.0;

// Returns the tile's normal at the point, flatter the more of its texels a pixel holds. Where none is left it
// is not read.
vec3 detail_normal(MapIo map, sampler2D tile, ShadingPoint s) {
  const mat2 change = map_uv_change(map, s);
  const vec2 side = vec2(textureSize(tile, 0)), dx = change[0] * side, dy = change[1] * side;
  const float texels2 = max(dot(dx, dx), dot(dy, dy));  // of the axis along which they change faster
  if (texels2 >= detail_gone * detail_gone) return vec3(0.0, 0.0, 1.0);

  const vec3 n = textureLod(tile, map_uv(map, s), 0.5 * log2(max(texels2, 1e-12))).xyz * 2.0 - 1.0;
  const float strength = map.scale * (1.0 - smoothstep(detail_whole, detail_gone, sqrt(texels2)));
  return vec3(n.xy * strength, max(n.z, 0.1));
}

// Returns mapped_normal() with the relief of the tile added: slopes of heights add up.
vec3 detailed_normal(MapIo map, sampler2D normal_map, MapIo detail, sampler2D tile, ShadingPoint s) {
  const vec3 t = is_present(map) ? mapped_slope(map, normal_map, s) : vec3(0.0, 0.0, 1.0);
  const vec3 d = detail_normal(detail, tile, s);
  return from_tangent_space(vec3(t.xy * d.z + d.xy * t.z, t.z * d.z), s);
}
