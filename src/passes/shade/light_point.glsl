// SPDX-License-Identifier: MIT
// Where a point of the skin reads its light map. Needs `io`.
// Returns the position of an unwrap coordinate in the pool of light maps, texels: in the square of the head,
// with its bilinear footprint. Half a texel inside, plus the step to which samplers round: outside the square
// there may be NaN, which a weight of 0 does not remove. With the step, the extra texel lies inside and
// weighs at most 1/256.
vec2 light_point(vec2 unwrap) {
  const float margin = 0.5 + 1.0 / 256.0;
  return clamp(unwrap * float(io.map_side), margin, float(io.map_side) - margin) + vec2(io.map_origin);
}
