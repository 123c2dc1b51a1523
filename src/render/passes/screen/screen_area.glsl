// SPDX-License-Identifier: MIT
// The pixels that hold all heads, of which alone passes in screen space write any. The outermost have no skin
// unless they are the picture's own, which may lie within a larger image. Needs ScreenIo `io` and sampler
// `light`.
ivec2 in_area(ivec2 p) { return clamp(p, ivec2(io.low), ivec2(io.low + io.size) - 1); }

// Keeps a bilinear footprint inside: half a pixel, plus the step to which samplers round. Beside the pixels
// there may be NaN, which a weight of 0 does not take away: who reads a single row has to ask for it.
vec2 in_area(vec2 p) {
  const vec2 margin = min(vec2(0.5 + 1.0 / 256.0), 0.5 * vec2(io.size));
  return clamp(p, vec2(io.low) + margin, vec2(io.low + io.size) - margin);
}

// Returns the light between the pixels around a point, of those that are skin; `none` where hardly one is,
// and where there is no number.
vec3 skin_light(vec2 pixels, vec3 none) {
  const vec4 found = textureLod(light, in_area(pixels) / vec2(io.extent), 0.0);
  return found.a >= 1e-4 ? found.rgb / found.a : none;
}
