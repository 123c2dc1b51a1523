// SPDX-License-Identifier: MIT
// Where skin reads its light: what leaves towards the eye came up along the refracted ray, from below a place
// further away from the eye (ShapeLaws::exit_offset_mm). Needs `terms` (SkinTermsIo) and `io` (ShadeIo).

// Returns the change of unwrap coordinates. border_mm: of body_shape(). n, to_eye: unit.
vec2 exit_offset(AlongSkin along, float border_mm, vec3 n, vec3 to_eye) {
  // Beside an open border there is no light. Ways along edges are longer than straight ones.
  const float offset_m = min(terms.exit_offset_m, 0.7 * border_mm * terms.m_per_mm);
  const vec3 away_m = (n * dot(n, to_eye) - to_eye) * offset_m;
  return vec2(dot(along.u, away_m), dot(along.v, away_m));
}
