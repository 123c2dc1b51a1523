// SPDX-License-Identifier: MIT
// Light that arrives at a point, with its shadow. Needs: buffers `lights` (LightIo[]), `shadow_matrices` (mat4[]), sampler2DArrayShadow `shadow_maps`,
// sampler2DArray `shadow_depths`, the same to be read as it is.

struct Arriving {
  vec3 irradiance;       // on a surface that faces the light, unshadowed
  vec3 to_light;         // unit
  float distance_m;
};

// KHR_lights_punctual: inverse square, range window, smooth cone.
Arriving arriving_light(LightIo light, vec3 p) {
  Arriving a;
  if (light.type == LIGHT_DIRECTIONAL) {
    a.irradiance = light.colour;
    a.to_light = -light.direction;
    a.distance_m = 0.0;
    return a;
  }
  const vec3 d = light.position_m - p;
  const float d2 = max(dot(d, d), 1e-8);
  a.distance_m = sqrt(d2);
  a.to_light = d / a.distance_m;
  a.irradiance = light.colour / d2;
  if (light.range_m > 0.0) {
    const float x = a.distance_m / light.range_m;
    a.irradiance *= clamp(1.0 - x * x * x * x, 0.0, 1.0);
  }
  if (light.type == LIGHT_SPOT) {
    const float c = clamp((dot(light.direction, -a.to_light) - light.cos_outer) / max(light.cos_inner - light.cos_outer, 1e-4), 0.0, 1.0);
    a.irradiance *= c * c;
  }
  return a;
}

// Which of the six layers of an omnidirectional map a direction falls on: +x -x +y -y +z -z.
uint cube_face(vec3 d) {
  const vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0u : 1u;
  if (a.y >= a.z) return d.y > 0.0 ? 2u : 3u;
  return d.z > 0.0 ? 4u : 5u;
}

// The layer of a light's map that holds p.
uint shadow_layer_of(LightIo light, vec3 p) {
  return light.shadow_layer + (light.shadow_layers == 6u ? cube_face(p - light.position_m) : 0u);
}

// Side of a texel of a light's map where its light arrives.
float shadow_texel_m(LightIo light, Arriving a) {
  return light.type == LIGHT_DIRECTIONAL ? light.shadow_texel : light.shadow_texel * a.distance_m;
}

// p moved off its surface: so many texels along the normal where light grazes it, fewer where it is faced, and one towards the light.
vec3 off_the_surface(vec3 p, vec3 n_geometric, Arriving a, float texel_m, float texels) {
  const float cosine = dot(n_geometric, a.to_light), sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));
  return p + n_geometric * (texels * texel_m * sine) + a.to_light * texel_m;
}

#include "shared/soft_shadow.glsl"

// Percentage-closer filtering over 3 x 3 bilinear comparisons, tent weights: a stable soft edge about three texels wide. The receiver is moved along its
// geometric normal by the filter's radius (so a plane never shadows itself, whatever its slope) and a texel towards the light.
float shadow_at(LightIo light, Arriving a, vec3 p, vec3 n_geometric) {
  if (light.shadow_layers == 0u) return 1.0;
  const vec3 q = off_the_surface(p, n_geometric, a, shadow_texel_m(light, a), sign(dot(n_geometric, a.to_light)) * 2.5);
  const uint layer = shadow_layer_of(light, q);
  const mat4 from_world = shadow_matrices[layer];
  const vec4 clip = from_world * vec4(q, 1.0);
  if (clip.w <= 0.0) return 1.0;
  const vec3 ndc = clip.xyz / clip.w;
  const vec2 uv = ndc.xy * 0.5 + 0.5;
  if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return 1.0;
  const vec2 size = vec2(textureSize(shadow_maps, 0).xy);
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      const float weight = float((2 - abs(x)) * (2 - abs(y))) / 16.0;
      lit += weight * texture(shadow_maps, vec4(uv + vec2(x, y) / size, float(layer), ndc.z));
    }
  if (soft_shadows && light.radius > 0.0) return soft_shadow(light, a, from_world, p, n_geometric, float(layer), lit);
  return lit;
}
