// SPDX-License-Identifier: MIT
// Reads a material's maps at a point of a surface. Needs MaterialIo `material` and samplers map_base_colour
// ... (scene_io.h). COMPUTE_SHADING: in compute shaders, whose points bring their derivatives.
#include "render/shaders/switches.glsl"
#include "render/shaders/view_vector.glsl"
#include "render/shaders/shading_point.glsl"

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
