// SPDX-License-Identifier: MIT
// Where a point of the skin lies in a pool of light maps, texels: in the square of that side and origin. Seen edge on, even a sample on the
// triangle may be interpolated far outside of it: unwrap is kept in the triangle's box, and the bilinear footprint within the square.
vec2 light_point(vec2 unwrap, vec4 box, float side, vec2 origin) {
  return clamp(clamp(unwrap, box.xy, box.zw) * side, 0.5, side - 0.5) + origin;
}
vec2 light_point(vec2 unwrap, vec4 box) { return light_point(unwrap, box, float(io.map_side), vec2(io.map_origin)); }
