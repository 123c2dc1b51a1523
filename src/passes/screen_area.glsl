// SPDX-License-Identifier: MIT
// The pixels that hold all heads, of which alone passes in screen space write any. The outermost have no skin
// unless they are the picture's own, which may lie within a larger image. Needs ScreenIo `io`.
ivec2 in_area(ivec2 p) { return clamp(p, ivec2(io.low), ivec2(io.low + io.size) - 1); }

// Keeps a bilinear footprint inside: half a pixel, plus the step to which samplers round. Beside the pixels
// there may be NaN, which a weight of 0 does not take away: who reads a single row has to ask for it.
vec2 in_area(vec2 p) {
  const vec2 margin = min(vec2(0.5 + 1.0 / 256.0), 0.5 * vec2(io.size));
  return clamp(p, vec2(io.low) + margin, vec2(io.low + io.size) - margin);
}
