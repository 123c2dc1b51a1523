// SPDX-License-Identifier: MIT
// Relief finer than a texel of the normal map: a tiled map of normals, as near as a pixel shows it. Follows
// material.glsl.

// The finest furrows of a tile are some texels wide, and a tile that repeats shows only when they merge: the
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
