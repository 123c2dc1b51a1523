// SPDX-License-Identifier: MIT
// Rounds to the nearest half float, ties to even: on some devices stores truncate (a constant drifts by -0.4
// % over five blurs).
float round_to_half(float x) {
  const uint bits = floatBitsToUint(x);
  const uint rounded = (bits + 0x0FFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u;
  return uintBitsToFloat(rounded);
}
vec3 round_to_half(vec3 v) { return vec3(round_to_half(v.x), round_to_half(v.y), round_to_half(v.z)); }
vec4 round_to_half(vec4 v) { return vec4(round_to_half(v.xyz), round_to_half(v.w)); }

// Returns a value that a half float can hold: too bright light saturates, and a NaN from a degenerate
// triangle becomes dark, so that it cannot spread.
vec3 storable(vec3 v) {
  v = mix(v, vec3(0.0), isnan(v));
  return round_to_half(clamp(v, vec3(0.0), vec3(65000.0)));
}
