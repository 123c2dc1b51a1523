// SPDX-License-Identifier: MIT
// Where the edge of a shadow is: shadows filtered over a disc that faces the light, as wide as skin scatters.
// Follows lights.glsl.
layout(constant_id = 20) const int shadow_taps = 32;

// Returns the distance of a straight edge from the middle of a disc of which this share is lit, in radii.
// With x = sin(E / 2), the share is 1/2 + (E + sin E) / 2 pi, solved by two Newton steps from the far end.
float edge_in_disc(float share) {
  const float y = pi * abs(2.0 * share - 1.0), rest = pi - y;
  float d = pow(6.0 * rest, 1.0 / 3.0);
  for (int i = 0; i < 2; ++i) d -= (d - sin(d) - rest) / max(1.0 - cos(d), 1e-4);
  return sign(share - 0.5) * clamp(cos(0.5 * d), 0.0, 1.0);
}

// The same for share_not_beyond(), whose filter is about a tent of two texels on either side.
float edge_in_tent(float share) {
  return share < 0.5 ? sqrt(8.0 * share) - 2.0 : 2.0 - sqrt(8.0 * (1.0 - share));
}

// Returns the lit share of a disc of this radius around a point of the map. A tap is lit unless something
// there is nearer to the light than the surface: than its tangent plane, or 60 degrees where that falls away
// more steeply. rise: by how much skin beside the point may be nearer, of its distance, and still be a
// hollow.
float disc_lit(MapLook m, MapRay ray, float radius_m, float texel_m, float rise) {
  const float depth = m.clip.z / m.clip.w, radius = min(radius_m / texel_m, 0.5 * m.side);
  float lit = 0.0;
  for (int i = 0; i < shadow_taps; ++i) {
    const float r = radius * sqrt((float(i) + 0.5) / float(shadow_taps)), angle = 2.39996323 * float(i);
    const vec2 at = m.here + r * vec2(cos(angle), sin(angle)), base = floor(at - 0.5), f = at - 0.5 - base;

    const float off_m = r * texel_m;
    const float plane_m = way_of(ray, max(depth + dot(m.slope, at - m.here), 0.0)),
                free_m = max(plane_m, -1.7 * off_m) + 1.5 * texel_m + rise * off_m;
    const float free = (ray.clip.z + free_m * ray.zw.x) / (ray.clip.w + free_m * ray.zw.y);

    const vec4 z = textureGather(shadow_depths, in_layer(base + 1.0, m.layer));
    const vec4 open = step(z, vec4(free));  // (0,1) (1,1) (1,0) (0,0)
    const bool known = all(greaterThan(at, vec2(0.5))) && all(lessThan(at, vec2(m.side - 0.5)));
    lit += known ? mix(mix(open.w, open.z, f.x), mix(open.x, open.y, f.x), f.y) : 1.0;
  }
  return lit / float(shadow_taps);
}

// Returns the distance of a point inside the light from the edge of its shadow, across the light, m; negative
// in the shadow, at most `radius_m`. through_m: how far the light goes through the skin around the point,
// where it faces away; that skin is no occluder.
float lit_distance_m(LightIo light, Arriving a, ShadingPoint s, float radius_m, float through_m) {
  if (light.shadow_layers == 0u) return radius_m;
  const float texel_m = shadow_texel_m(light, a);
  const vec3 q = shadow_point(s, a, texel_m) + a.to_light * through_m;
  const MapLook m = look_into_map(light, q, s.normal, a.to_light);
  if (!m.inside) return radius_m;

  // Beside the edge the few texels of the ordinary filter know better where it is than taps far apart. Their
  // weights sum to 1 but for rounding.
  const float sharp = share_not_beyond(m);
  const bool lit = sharp >= 1.0 - 1e-4, dark = sharp <= 1e-4;
  if (!lit && !dark) return edge_in_tent(sharp) * texel_m;

  const MapRay ray = MapRay(m.clip, (m.from_world * vec4(a.to_light, 0.0)).zw);
  // Skin in shadow has an occluder, and may lie deep in a fold. Beside lit skin, rises of up to 45 degrees
  // are a hollow.
  const float rise = lit ? 1.0 : 0.1;
  const float wide_m = radius_m * edge_in_disc(disc_lit(m, ray, radius_m, texel_m, rise));
  return lit ? max(wide_m, 2.0 * texel_m) : min(wide_m, -2.0 * texel_m);
}
