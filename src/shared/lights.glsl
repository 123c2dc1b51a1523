// SPDX-License-Identifier: MIT
// Light that arrives at a point, with its shadow. Needs: buffers `lights` (LightIo[]), `shadow_matrices`
// (mat4[]), sampler2DArray `shadow_depths`, read as it is.

struct Arriving {
  vec3 irradiance;  // on a surface that faces the light, unshadowed
  vec3 to_light;    // unit
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
    const float c = clamp(
        (dot(light.direction, -a.to_light) - light.cos_outer) / max(light.cos_inner - light.cos_outer, 1e-4),
        0.0, 1.0);
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

// p moved off its surface: so many texels along the normal where light grazes it, fewer where it is faced,
// and one towards the light.
vec3 off_the_surface(vec3 p, vec3 n_geometric, Arriving a, float texel_m, float texels) {
  const float cosine = dot(n_geometric, a.to_light), sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));
  return p + n_geometric * (texels * texel_m * sine) + a.to_light * texel_m;
}

#include "shared/soft_shadow.glsl"

// Texels base-1 .. base+2 along both axes, four gathers: [x + 2 y] = the block of two by two that begins at
// base - 1 + 2 (x, y), in the order of textureGather: (0,1) (1,1) (1,0) (0,0).
void gather_depths(vec2 base, vec2 size, float layer, out vec4 z[4]) {
  for (int k = 0; k < 4; ++k)
    z[k] = textureGather(shadow_depths, vec3((base + 2.0 * vec2(k & 1, k >> 1)) / size, layer));
}

// The share of a tent over 3 x 3 bilinear comparisons that is not beyond `depth`, as weights of 4 x 4
// comparisons.
float share_not_beyond(vec4 z[4], vec2 f, float depth) {
  const vec4 x = vec4(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x) * 0.25,
             y = vec4(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y) * 0.25;
  float sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    const vec2 u = (k & 1) == 0 ? x.xy : x.zw, v = (k >> 1) == 0 ? y.xy : y.zw;
    sum += dot(vec4(u.x * v.y, u.y * v.y, u.y * v.x, u.x * v.x), step(z[k], vec4(depth)));
  }
  return sum;
}

// Percentage-closer filtering with tent weights: a stable soft edge about three texels wide. Gathers cost
// less than comparisons by the sampler, of which it took nine. The receiver is moved along its geometric
// normal by the filter's radius (so a plane never shadows itself, whatever its slope) and a texel towards the
// light.
float shadow_at(LightIo light, Arriving a, vec3 p, vec3 n_geometric) {
  if (light.shadow_layers == 0u) return 1.0;
  const vec3 q =
      off_the_surface(p, n_geometric, a, shadow_texel_m(light, a), sign(dot(n_geometric, a.to_light)) * 2.5);
  const uint layer = shadow_layer_of(light, q);
  const mat4 from_world = shadow_matrices[layer];
  const vec4 clip = from_world * vec4(q, 1.0);
  if (clip.w <= 0.0) return 1.0;
  const vec2 uv = clip.xy / clip.w * 0.5 + 0.5;
  if (any(lessThan(uv, vec2(0.0))) || any(greaterThan(uv, vec2(1.0)))) return 1.0;

  const vec2 size = vec2(textureSize(shadow_depths, 0).xy), base = floor(uv * size - 0.5),
             f = uv * size - 0.5 - base;
  vec4 z[4];
  gather_depths(base, size, float(layer), z);
  const float lit = share_not_beyond(z, f, clip.z / clip.w);
  if (soft_shadows && light.radius > 0.0)
    return soft_shadow(light, a, from_world, p, n_geometric, float(layer), lit);
  return lit;
}
