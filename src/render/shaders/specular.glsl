// SPDX-License-Identifier: MIT
// Specular reflection of skin. Based on: [DLE07] d'Eon, Luebke, Enderton:
// Efficient Rendering of Human Skin, EGSR 2007 (GPU Gems 3, ch. 14.3). [WMLT07] Walter et al.: Microfacet
// Models for Refraction through Rough Surfaces, EGSR 2007; [Hei14] Heitz: Understanding the Masking-Shadowing
// Function, JCGT 3(2), 2014. The lobe is pi times a normalised Beckmann lobe, so rho_s = 0.18 is an energy
// scale of 0.565. As a BRDF it multiplies irradiance directly, and the directional albedo, rho_s * rho, is
// exactly what it reflects. A technique that includes a lobe of its own before this file defines OWN_LOBE.

const float pi = 3.14159265358979;

// Returns Beckmann's distribution without 1/pi: exp(-tan^2/m^2) / (m^2 cos^4).
float beckmann(float n_h, float m) {
  const float c2 = max(n_h * n_h, 1e-6);
  return exp(-(1.0 - c2) / (c2 * m * m)) / (m * m * c2 * c2);
}

#ifndef OWN_LOBE
// Constants of mirrored surroundings, see skin_answer.glsl.
const float lobe_bend = 1.35, lobe_least_cosine = 0.15;

// Returns cosine times Smith's Lambda for Beckmann's distribution, [WMLT07] eq. 27: finite at 0.
float cosine_lambda(float cosine, float m) {
  const float t = m * sqrt(max(1.0 - cosine * cosine, 1e-8));
  const float a = cosine / t;
  return a < 1.6 ? t * (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 + 2.181 * a) : 0.0;
}

// The lobe is D F over this: 4 n.l n.v / G, with Smith's masking, correlated by height: G = 1 / (1 +
// Lambda(v) + Lambda(l)), [Hei14] eq. 99. It stays above 0 where h = l + v goes to 0.
float lobe_divisor(vec3 n, vec3 v, vec3 l, float h2, float m) {
  const float n_v = max(dot(n, v), 1e-4), n_l = max(dot(n, l), 1e-4);
  return 4.0 * (n_l * n_v + n_l * cosine_lambda(n_v, m) + n_v * cosine_lambda(n_l, m));
}

// Returns the lobe's entry in the table of the directional albedo.
vec2 lobe_albedo(vec4 entry) { return entry.xy; }
#endif

// Beckmann's distribution with Schlick's Fresnel, over what the form of the lobe divides by.
float specular_lobe(vec3 n, vec3 v, vec3 l, float m, float f0) {
  const vec3 h_raw = l + v;
  const float h2 = dot(h_raw, h_raw);
  if (h2 < 1e-8) return 0.0;
  const vec3 h = h_raw * inversesqrt(h2);
  const float x = pow(clamp(1.0 - dot(v, h), 0.0, 1.0), 5.0);
  return beckmann(max(dot(n, h), 0.0), m) * (f0 + (1.0 - f0) * x) / lobe_divisor(n, v, l, h2, m);
}

float f0_of_ior(float ior) {
  const float r = (ior - 1.0) / (ior + 1.0);
  return r * r;
}

// rho(cos, m) = int f cos dw = f0 * table.x + table.y. Rows are m (0.05 to 1), columns cos (0 to 1), the last
// column holds the cosine-weighted mean over cos. See tissue/optics/directional_albedo.h.
const int directional_albedo_columns = 64;
const int directional_albedo_rows = 32;
const float directional_albedo_min_m = 0.05;

float directional_albedo_lookup(sampler2D table, float cosine, float m, float f0) {
  const float column = clamp(cosine, 0.0, 1.0) * float(directional_albedo_columns - 1) + 0.5;
  const float row = clamp((m - directional_albedo_min_m) / (1.0 - directional_albedo_min_m), 0.0, 1.0) *
                        float(directional_albedo_rows - 1) +
                    0.5;
  const vec2 t = lobe_albedo(textureLod(
      table, vec2(column / float(directional_albedo_columns + 2), row / float(directional_albedo_rows)),
      0.0));
  return f0 * t.x + t.y;
}
float directional_albedo_mean(sampler2D table, float m, float f0) {
  const float row = clamp((m - directional_albedo_min_m) / (1.0 - directional_albedo_min_m), 0.0, 1.0) *
                        float(directional_albedo_rows - 1) +
                    0.5;
  const vec2 t = lobe_albedo(
      textureLod(table,
                 vec2((float(directional_albedo_columns) + 1.5) / float(directional_albedo_columns + 2),
                      row / float(directional_albedo_rows)),
                 0.0));
  return f0 * t.x + t.y;
}

// The two lobes of one point of skin.
struct SkinSpecular {
  float rho_s;  // 0 switches it off
  float f0;
  vec2 m;
  vec2 weight;
};

float specular_brdf(SkinSpecular s, vec3 n, vec3 v, vec3 l) {
  return s.rho_s * (s.weight.x * specular_lobe(n, v, l, s.m.x, s.f0) +
                    s.weight.y * specular_lobe(n, v, l, s.m.y, s.f0));
}
// Returns the part of light from (or to) this direction that the surface reflects; clamped, so that painted
// maps cannot reflect all of it.
float specular_albedo(sampler2D table, SkinSpecular s, float cosine) {
  return min(s.rho_s * (s.weight.x * directional_albedo_lookup(table, cosine, s.m.x, s.f0) +
                        s.weight.y * directional_albedo_lookup(table, cosine, s.m.y, s.f0)),
             0.9);
}
float specular_albedo_mean(sampler2D table, SkinSpecular s) {
  return min(s.rho_s * (s.weight.x * directional_albedo_mean(table, s.m.x, s.f0) +
                        s.weight.y * directional_albedo_mean(table, s.m.y, s.f0)),
             0.9);
}
