// SPDX-License-Identifier: MIT
// The specular lobe of GPU Gems 3, ch. 14.3, after [KSK01] Kelemen, Szirmay-Kalos: A Microfacet Based Coupled
// Specular-Matte BRDF Model, EG 2001. It has no bound where h goes to 0, for a light behind the head: other
// techniques mask by Smith. Precedes shaders/specular.glsl.
#define OWN_LOBE

// Of mirrored surroundings, see shaders/skin_answer.glsl.
const float lobe_bend = 0.9, lobe_least_cosine = 0.0;

float beckmann(float n_h, float m);  // shaders/specular.glsl

// [KSK01] eq. 6 with Schlick's Fresnel: PH F / (h.h), h = L + V not normalised.
float specular_lobe(vec3 n, vec3 v, vec3 l, float m, float f0) {
  const vec3 h_raw = l + v;
  const float h2 = dot(h_raw, h_raw);
  if (h2 < 1e-8) return 0.0;
  const vec3 h = h_raw * inversesqrt(h2);
  const float x = pow(clamp(1.0 - dot(v, h), 0.0, 1.0), 5.0);
  return beckmann(max(dot(n, h), 0.0), m) * (f0 + (1.0 - f0) * x) / h2;
}

// Returns the lobe's entry in the table of the directional albedo.
vec2 lobe_albedo(vec4 entry) { return entry.zw; }
