// SPDX-License-Identifier: MIT
// The specular lobe of GPU Gems 3, ch. 14.3, after [KSK01] Kelemen, Szirmay-Kalos: A Microfacet Based Coupled
// Specular-Matte BRDF Model, EG 2001. It has no bound where h goes to 0, for a light behind the head: other
// techniques mask by Smith. Precedes render/shaders/specular.glsl.
#define OWN_LOBE

// Constants of mirrored surroundings, see render/shaders/skin_answer.glsl.
const float lobe_bend = 0.9, lobe_least_cosine = 0.0;

// [KSK01] eq. 6: PH F / (h.h), h = L + V not normalised.
float lobe_divisor(vec3 n, vec3 v, vec3 l, float h2, float m) { return h2; }

// Returns the lobe's entry in the table of the directional albedo.
vec2 lobe_albedo(vec4 entry) { return entry.zw; }
