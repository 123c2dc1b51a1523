// SPDX-License-Identifier: MIT
// Light that arrives at a point, with its shadow. Needs head.glsl, material.glsl and
// sampler2DArray `shadow_depths` without comparison.
#extension GL_EXT_samplerless_texture_functions : require
layout(binding = 5) uniform utextureBuffer Lamps;  // of all heads, see LampsIo

LightIo light_at(uint number) {
  const int first = of_head.lamps.lights + LIGHT_TEXELS * int(number);
  const uvec4 a = texelFetch(Lamps, first), b = texelFetch(Lamps, first + 1),
              c = texelFetch(Lamps, first + 2), d = texelFetch(Lamps, first + 3),
              e = texelFetch(Lamps, first + 4);

  LightIo light;
  light.colour = uintBitsToFloat(a.xyz);
  light.type = a.w;
  light.position_m = uintBitsToFloat(b.xyz);
  light.range_m = uintBitsToFloat(b.w);
  light.direction = uintBitsToFloat(c.xyz);
  light.cos_inner = uintBitsToFloat(c.w);
  light.cos_outer = uintBitsToFloat(d.x);
  light.shadow_layer = d.y;
  light.shadow_layers = d.z;
  light.shadow_texel = uintBitsToFloat(d.w);
  light.radius = uintBitsToFloat(e.x);
  light.shadow_side = uintBitsToFloat(e.y);
  return light;
}

mat4 shadow_matrix(uint layer) {
  const int first = of_head.lamps.shadow_matrices + 4 * int(layer);
  return mat4(uintBitsToFloat(texelFetch(Lamps, first)), uintBitsToFloat(texelFetch(Lamps, first + 1)),
              uintBitsToFloat(texelFetch(Lamps, first + 2)), uintBitsToFloat(texelFetch(Lamps, first + 3)));
}

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

// Returns the layer of an omnidirectional map for a direction: +x -x +y -y +z -z.
uint cube_face(vec3 d) {
  const vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x > 0.0 ? 0u : 1u;
  if (a.y >= a.z) return d.y > 0.0 ? 2u : 3u;
  return d.z > 0.0 ? 4u : 5u;
}

// Returns the layer of a light's map that holds p.
uint shadow_layer_of(LightIo light, vec3 p) {
  return light.shadow_layer + (light.shadow_layers == 6u ? cube_face(p - light.position_m) : 0u);
}

// Returns the side of a texel of a light's map at the distance of the point.
float shadow_texel_m(LightIo light, Arriving a) {
  return light.type == LIGHT_DIRECTIONAL ? light.shadow_texel : light.shadow_texel * a.distance_m;
}

// The smallest cosine of the light at which a shadow is compared with the plane of the surface as it is. A
// steeper plane would hide real occluders beside the point.
const float steepest = 0.4;

// Shadow bias: returns a point moved along its normal by up to `texels`, the more the light grazes, or to the
// rounded surface if that is further. Plus `towards` texels towards the light.
vec3 off_the_surface(ShadingPoint s, Arriving a, float texel_m, float texels, float towards) {
  const float cosine = dot(s.normal, a.to_light), sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));
  return s.shadow_m + s.normal * max(texels * texel_m * sine, s.bulge_m) + a.to_light * (towards * texel_m);
}

// Returns the point whose plane is compared. Where that is less steep than the surface, the point is clear of
// the rest: the filter reaches two and a half texels. Facets and hollows rise above their plane by a little
// more. Towards the light this moves no edge, but lets light come through at contacts.
vec3 shadow_point(ShadingPoint s, Arriving a, float texel_m) {
  const float rest = 1.0 - max(dot(s.normal, a.to_light), 0.0) / steepest;
  return off_the_surface(s, a, texel_m, max(0.25, 2.5 * rest), 2.0);
}

// Returns texture coordinates of a position in a light's map, texels. The map lies in the corner of its
// layers, as large as its head needs.
vec3 in_layer(vec2 at, float layer) { return vec3(at / vec2(textureSize(shadow_depths, 0).xy), layer); }

#include "render/shaders/soft_shadow.glsl"

// The texels of a light's map around a point.
struct MapLook {
  mat4 from_world;
  vec4 clip;     // of the point
  vec2 here;     // its position in the map
  float side;    // of the map
  vec2 between;  // its position between the middle four texels, 0..1
  vec2 slope;    // of the plane of the surface there: depth per texel
  vec4 z[4];     // depths of the 4 x 4 texels around: [x + 2 y] is a block of two by two, in the order of
                 // textureGather: (0,1) (1,1) (1,0) (0,0)
  float layer;
  bool inside;  // false: the point is outside the map, or at its border, and z is not set
};

MapLook look_into_map(LightIo light, vec3 p, vec3 normal, vec3 to_light) {
  MapLook m;
  const uint layer = shadow_layer_of(light, p);
  m.layer = float(layer);
  m.from_world = shadow_matrix(layer);
  m.clip = m.from_world * vec4(p, 1.0);
  m.side = light.shadow_side;
  m.here = (m.clip.xy / m.clip.w * 0.5 + 0.5) * m.side;
  m.inside = m.clip.w > 0.0 && all(greaterThanEqual(m.here, vec2(2.0))) &&
             all(lessThanEqual(m.here, vec2(m.side - 2.0)));
  if (!m.inside) return m;

  const vec2 base = floor(m.here - 0.5);
  m.between = m.here - 0.5 - base;
  m.slope = depth_slope(m.from_world, m.clip, normal, to_light, steepest) / m.side;
  for (int k = 0; k < 4; ++k)
    m.z[k] = textureGather(shadow_depths, in_layer(base + 2.0 * vec2(k & 1, k >> 1), m.layer));
  return m;
}

// Returns the share of a tent over 3 x 3 bilinear comparisons where nothing is nearer to the light than the
// plane of the surface, as weights of 4 x 4 comparisons. A plane never shadows itself, at any slope.
float share_not_beyond(MapLook m) {
  const vec2 f = m.between, s = m.slope;
  const float first = m.clip.z / m.clip.w - dot(s, 1.0 + f);  // of the plane at the first texel
  const vec4 x = vec4(1.0 - f.x, 2.0 - f.x, 1.0 + f.x, f.x) * 0.25,
             y = vec4(1.0 - f.y, 2.0 - f.y, 1.0 + f.y, f.y) * 0.25;
  float sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    const vec2 u = (k & 1) == 0 ? x.xy : x.zw, v = (k >> 1) == 0 ? y.xy : y.zw;
    const float plane = first + 2.0 * dot(s, vec2(k & 1, k >> 1));
    sum += dot(vec4(u.x * v.y, u.y * v.y, u.y * v.x, u.x * v.x),
               step(m.z[k], max(plane + vec4(s.y, s.x + s.y, s.x, 0.0), 0.0)));
  }
  return sum;
}

// Returns the share of the light that arrives at the point, 0..1, from the texels around it:
// percentage-closer filtering with tent weights, a stable soft edge about three texels wide. Gathers cost
// less than the nine comparisons of a comparison sampler.
float share_lit(LightIo light, Arriving a, ShadingPoint s, MapLook m) {
  const float lit = share_not_beyond(m);
  if (soft_shadows && light.radius > 0.0) return soft_shadow(light, a, m.from_world, s, m.layer, lit);
  return lit;
}

// Returns the share of the light that arrives at a surface, of which either side may face the light.
float shadow_at(LightIo light, Arriving a, ShadingPoint s) {
  if (light.shadow_layers == 0u) return 1.0;
  ShadingPoint facing = s;
  if (dot(s.normal, a.to_light) < 0.0) {
    facing.normal = -s.normal;
    facing.bulge_m = -s.bulge_m;
  }
  const vec3 q = shadow_point(facing, a, shadow_texel_m(light, a));
  const MapLook m = look_into_map(light, q, facing.normal, a.to_light);
  return m.inside ? share_lit(light, a, s, m) : 1.0;
}
