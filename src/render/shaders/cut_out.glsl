// SPDX-License-Identifier: MIT
// The alpha test of skin. Reads maps at full resolution, so that light map, stretch map, picture and
// reference agree. A specialisation constant, so that skin without alpha test pays nothing. Needs:
// scene_io.h, `material`, map_base_colour.
layout(constant_id = 11) const bool cut_out = false;

vec2 alpha_uv(vec4 uv) {
  const MapIo map = material.maps[MAP_BASE_COLOUR];
  const vec2 own = map.uv_set == 0u ? uv.xy : uv.zw;
  return map.u_axis * own.x + map.v_axis * own.y + map.offset;
}

// uv: both sets of texture coordinates.
bool is_cut(vec4 uv, vec4 colour) {
  return material.base_colour.a * colour.a * textureLod(map_base_colour, alpha_uv(uv), 0.0).a <
         material.alpha_cutoff;
}
