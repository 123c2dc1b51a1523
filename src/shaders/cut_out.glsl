// SPDX-License-Identifier: MIT
// The alpha test of skin. Maps are read as they are, without levels of detail: light map, stretch map,
// picture and reference then agree about what is there. A constant, so that skin that is not cut out pays
// nothing for it. Needs: scene_io.h, `material`, map_base_colour.
layout(constant_id = 11) const bool cut_out = false;

vec2 alpha_uv(vec4 uv) {
  const MapIo map = material.maps[MAP_BASE_COLOUR];
  const vec2 own = map.uv_set == 0u ? uv.xy : uv.zw;
  return map.u_axis * own.x + map.v_axis * own.y + map.offset;
}

// uv: both sets.
bool is_cut(vec4 uv, vec4 colour) {
  return material.base_colour.a * colour.a * textureLod(map_base_colour, alpha_uv(uv), 0.0).a <
         material.alpha_cutoff;
}
