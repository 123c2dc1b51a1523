// SPDX-License-Identifier: MIT
// Penumbrae of lights that are discs, which face the lit point. The map is
// back-projected onto the light: an occluder at a distance towards the light, beside the ray to its centre,
// hides one point of the disc. In each of a few directions hidden points are collected as bits, so that
// occluders behind each other do not count twice. Based on: [GBP06] Guennebaud, Barthe, Paulin: Real-time
// Soft Shadow Mapping by Backprojection, EGSR 2006 (samples of the map are small plates in space). [TLG23]
// Therrien, Levesque, Gilet: Screen Space Indirect Lighting with Visibility Bitmask, The Visual Computer
// 2023. Needs: sampler2DArray `shadow_depths`.
layout(constant_id = 10) const bool soft_shadows = false;

const int soft_directions = 8, soft_steps = 10;
const float solid_m = 0.006;  // occluders are at least this thick: noses, lips, rims of ears

// Converts metres along the light to depth: the depth of a point at `clip`, moved by m towards the light, is
// (clip.z + m zw.x) / (clip.w + m zw.y).
struct MapRay {
  vec4 clip;
  vec2 zw;
};
float way_of(MapRay ray, float depth) {
  return (depth * ray.clip.w - ray.clip.z) / (ray.zw.x - depth * ray.zw.y);
}

// Returns the slope of the plane through the point with this normal: depth per side of the map. A plane stays
// a plane under projection, so two directions in it suffice. Where the light has a smaller cosine, the plane
// is turned towards the light, else its slope would diverge.
vec2 depth_slope(mat4 from_world, vec4 clip, vec3 n, vec3 to_light, float least_cosine) {
  n = normalize(n + max(least_cosine - dot(n, to_light), 0.0) * to_light);
  const vec3 t = normalize(cross(n, abs(n.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0))),
             b = cross(n, t);
  const vec4 along_t = from_world * vec4(t, 0.0), along_b = from_world * vec4(b, 0.0);
  const vec3 ndc = clip.xyz / clip.w, dt = along_t.xyz - ndc * along_t.w, db = along_b.xyz - ndc * along_b.w;
  return 2.0 * vec2(dt.z * db.y - db.z * dt.y, db.z * dt.x - dt.z * db.x) / (dt.x * db.y - db.x * dt.y);
}

// Returns the radius, in texels of the map, within which something `way_m` nearer to the light hides part of
// it.
float penumbra_texels(LightIo light, Arriving a, float way_m) {
  const float per_m = light.radius / light.shadow_texel;
  if (light.type == LIGHT_DIRECTIONAL) return per_m * way_m;
  return per_m * way_m / (a.distance_m * max(a.distance_m - way_m, 0.01 * a.distance_m));
}

// Returns the tangent of the angular radius of a light.
float light_tangent(LightIo light, Arriving a) {
  if (!soft_shadows) return 0.0;
  return light.type == LIGHT_DIRECTIONAL ? light.radius : light.radius / a.distance_m;
}

// Returns the mean over the light of its cosine where that is positive: c + t s y over the unit disc, with s
// the sine. The light sets over an angle, not at once.
float light_cosine(float c, float tangent) {
  if (!soft_shadows) return max(c, 0.0);
  tangent *= sqrt(max(1.0 - c * c, 0.0));
  if (tangent <= 0.0 || c >= tangent) return max(c, 0.0);
  if (c <= -tangent) return 0.0;
  const float x = c / tangent, root = sqrt(1.0 - x * x);
  return tangent * (x * (0.5 + (x * root + asin(x)) / 3.14159265) + 0.21220659 * root * root * root);
}

// Returns the bits of a direction, 32 rings of the disc of equal area, between two distances from its centre.
uint rings(float from, float to) {
  const uint first = uint(clamp(from * from, 0.0, 1.0) * 32.0 + 0.5),
             last = uint(clamp(to * to, 0.0, 1.0) * 32.0 + 0.5);
  return last <= first ? 0u : (0xFFFFFFFFu >> (32u - (last - first))) << first;
}

// Returns the share of light_cosine() that arrives at the point in this layer; `hard` is that of a point
// light. Directions are rotated by an angle fixed to the texel of the shadow map, so that errors do not move
// with the camera.
float soft_shadow(LightIo light, Arriving a, mat4 from_world, ShadingPoint s, float layer, float hard) {
  const float texel_m = shadow_texel_m(light, a);
  const float cosine = dot(s.normal, a.to_light), tangent = light_tangent(light, a),
              sine = sqrt(clamp(1.0 - cosine * cosine, 0.0, 1.0));

  // Starts clear of the surface, which is not exactly the plane of its normal.
  const vec4 clip = from_world * vec4(off_the_surface(s, a, texel_m, 1.5, 1.0), 1.0);
  if (clip.w <= 0.0) return hard;

  const float side = light.shadow_side;
  const MapRay ray = MapRay(clip, (from_world * vec4(a.to_light, 0.0)).zw);
  const vec2 slope = depth_slope(from_world, clip, s.normal, a.to_light, 0.1) / side;  // per texel
  const float depth = clip.z / clip.w, steepness = length(slope);
  const float horizon = tangent * sine / max(steepness, 1e-15);

  const vec2 here = (clip.xy / clip.w * 0.5 + 0.5) * side;
  const vec2 noise =
      fract(52.9829189 * fract(floor(here) * mat2(0.06711056, 0.00583715, 0.00583715, 0.07711056)));
  // The penumbra of the nearest possible occluder, at most half the map: maps of lights inside the scene
  // begin close to them.
  const float reach = clamp(penumbra_texels(light, a, way_of(ray, 1.0)), 0.0, 0.5 * side);

  float whole = 0.0, lit = 0.0, widest = 0.0;
  for (int i = 0; i < soft_directions; ++i) {
    const float angle = 6.2831853 * (noise.x + float(i)) / float(soft_directions),
                jitter = fract(noise.y + 0.61803399 * float(i));
    const vec2 direction = vec2(cos(angle), sin(angle));
    const float rise = dot(slope, direction);
    uint hidden = 0u;
    float r = 0.0;

    for (int k = 0; k < soft_steps; ++k) {
      // Steps grow outwards: near occluders hide the light with texels near the ray.
      const float t = (float(k) + jitter) / float(soft_steps), t_next = t + 1.0 / float(soft_steps),
                  next = reach * t_next * t_next * t_next;
      const vec2 at = floor(here + direction * (0.5 * (r + next))) + 0.5;
      const float way_m = way_of(ray, textureLod(shadow_depths, in_layer(at, layer), 0.0).x);
      const float plane_m = max(way_of(ray, max(depth + dot(slope, at - here), 0.0)), 0.0);
      const bool known = all(greaterThan(at, vec2(0.0))) &&
                         all(lessThan(at, vec2(side)));  // six maps around a light end at their borders
      if (known && way_m > plane_m + texel_m * (0.3 + 0.02 * next)) {
        // An occluding plate from r to next.
        const float penumbra = max(penumbra_texels(light, a, way_m), 1.5);
        hidden |= rings(r / penumbra, next / max(penumbra_texels(light, a, way_m - solid_m), 1e-3));
        widest = max(widest, penumbra);
      }
      r = next;
    }

    // Rings of the light count by their cosine.
    const float across = -horizon * rise;
    for (int g = 0; g < 4; ++g) {
      const float weight = max(cosine + across * sqrt((float(g) + 0.5) / 4.0), 0.0);
      whole += 8.0 * weight;
      lit += weight * float(8 - bitCount(hidden >> (8 * g) & 255u));
    }
  }

  // Contacts closer than the resolution of the map are left to its filter, but not near the horizon, where
  // the filter sees the surface itself.
  if (widest <= 1.5) return mix(1.0, hard, smoothstep(0.5 * tangent, tangent, cosine));
  return lit / max(whole, 1e-6);
}
