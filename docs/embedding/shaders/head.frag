// SPDX-License-Identifier: MIT
// Way (iii): the host's own shading of skin, around the light that dermis has spread in it. What light maps
// do not hold of the light, the host lights itself, with its own shadow map.
//
// What differs from dermis: one lobe of reflection in place of two; a fit in place of the tabulated albedo of
// the reflection; no shadow on highlights; nothing of the environment, of maps and of emission, because the
// scene has none.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "host.glsl"

// Where the host binds what HostFrames::record() returns.
#define DERMIS_SET 0
#define DERMIS_LIGHT_BINDING 1
#define DERMIS_RECORDS_BINDING 2
#include "dermis/scattered.glsl"
layout(set = 0, binding = 3) uniform sampler2DShadow shadow_map;

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 normal;
layout(location = 2) centroid in vec2 uv;
layout(location = 0) out vec4 colour;

const float strength = 0.18, f0 = 0.028;  // of the reflection; skin has an index of refraction of 1.4
const float mix_before = 0.5;  // dermis's default: half of the albedo acted before the light spread

// Returns the radiance that is reflected per irradiance on a surface that faces the light: Beckmann's lobe,
// with Schlick's Fresnel and Smith's masking, correlated by height. Based on: Walter et al.: Microfacet
// Models for Refraction through Rough Surfaces, EGSR 2007, eq. 27.
float cosine_lambda(float cosine, float slope) {
  const float t = slope * sqrt(max(1.0 - cosine * cosine, 1e-8)), a = cosine / t;
  return a < 1.6 ? t * (1.0 - 1.259 * a + 0.396 * a * a) / (3.535 + 2.181 * a) : 0.0;
}
float reflected(vec3 n, vec3 v, vec3 l, float slope) {
  const vec3 h = normalize(l + v);
  const float n_h2 = max(dot(n, h), 1e-3) * max(dot(n, h), 1e-3), slope2 = slope * slope;
  const float lobe = exp(-(1.0 - n_h2) / (n_h2 * slope2)) / (slope2 * n_h2 * n_h2);
  const float fresnel = f0 + (1.0 - f0) * pow(1.0 - max(dot(v, h), 0.0), 5.0);
  const float n_v = max(dot(n, v), 1e-3), n_l = max(dot(n, l), 1e-3);
  const float masked = n_l * n_v + n_l * cosine_lambda(n_v, slope) + n_v * cosine_lambda(n_l, slope);
  return strength * lobe * fresnel / (4.0 * masked) * max(dot(n, l), 0.0);
}

// Returns the share of light along a direction that reflection does not send back: it enters or leaves.
float kept(float cosine) { return 1.0 - (0.016 + 0.16 * pow(1.0 - max(cosine, 0.0), 3.6)); }

// Returns the part of the lamp that is seen. Texels of 0.6 mm are steps, so the point moves away from them,
// more towards the lamp than off the skin. Off the skin shadows would be shorter.
float visible_lamp(vec3 n) {
  const vec3 away_m = 0.0003 * n + 0.0015 * to_lamp.xyz;
  const vec3 p = (shadow_from_world * vec4(position_m + away_m, 1.0)).xyz;
  return texture(shadow_map, vec3(p.xy * 0.5 + 0.5, p.z));
}

void main() {
  const vec3 n = normalize(normal), v = normalize(eye_m.xyz - position_m);

  const DermisScattered skin = dermis_scattered(record, uv);
  const float cosine = dot(n, to_lamp.xyz);
  const vec3 lit = lamp_irradiance.rgb * (max(cosine, 0.0) * visible_lamp(n) * kept(cosine) / pi);
  const vec3 diffuse =
      (skin.light * pow(albedo.rgb, vec3(1.0 - mix_before)) + skin.rest * lit * albedo.rgb) * kept(dot(n, v));

  const float slope = 0.85 * albedo.w * albedo.w;  // between dermis's two lobes, 0.75 and 1.3
  colour = vec4(diffuse + lamp_irradiance.rgb * reflected(n, v, to_lamp.xyz, slope), 1.0);
}
