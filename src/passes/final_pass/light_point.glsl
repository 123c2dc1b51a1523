// SPDX-License-Identifier: MIT
// Where a point of the skin reads its light map. Needs `io`.
// Returns the position of an unwrap coordinate in a pool of light maps, texels: in the square of that side
// and origin, with its bilinear footprint. Half a texel inside, plus the step to which samplers round:
// outside the square there may be NaN, which a weight of 0 does not remove. With the step, the extra texel
// lies inside and weighs at most 1/256.
vec2 light_point(vec2 unwrap, float side, vec2 origin) {
  const float margin = 0.5 + 1.0 / 256.0;
  return clamp(unwrap * side, margin, side - margin) + origin;
}
vec2 light_point(vec2 unwrap) { return light_point(unwrap, float(io.map_side), vec2(io.map_origin)); }
