// SPDX-License-Identifier: MIT
// Where a point of the skin lies in the pool of light maps, texels. Seen edge on, even a sample on the triangle may be interpolated far
// outside of it: unwrap is kept in the triangle's box, and the bilinear footprint within the square.
vec2 light_point(vec2 unwrap, vec4 box) {
  const float side = float(io.map_side);
  return clamp(clamp(unwrap, box.xy, box.zw) * side, 0.5, side - 0.5) + vec2(io.map_origin);
}
