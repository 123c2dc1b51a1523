// SPDX-License-Identifier: MIT
// One look into a light's map for both of its uses: how much of the light arrives where the surface faces it,
// and where and how the light has entered that comes through the body to a surface that faces away.
// Translucent shadow maps; docs/techniques.md says why it is so. Based on: [SD03] Dachsbacher, Stamminger:
// Translucent Shadow Maps, EGSR 2003 (what enters is a part of the shadow map, and is gathered in the light's
// view); [DLE07] GPU Gems 3, ch. 14.5 (thickness with the normals' correction). Needs: lights.glsl,
// entering_maps (sampler2DArray of the same layers), `transmission`, through_terms.

const int last_term = through_terms - 1,
          term_before = through_terms > 1 ? through_terms - 2 : 0;  // both gather around the ray of light

layout(constant_id = 15) const bool entering_stored = true;  // else all light enters, wherever something is

struct LightRead {
  float lit;      // 0..1, where the surface faces the light: as shadow_at()
  vec3 entering;  // albedo^mix of the skin at the lit point; 0 where the first thing that light meets is no
                  // skin
  float cosine;   // of the light there
  float facing;   // 0..1: how far the lit point faces away from here
  float way_m;    // from there to here, along the light
  // The same ways along rays beside, two sigma of the last term but one and of the last away; no light: far.
  vec4 way_near_m, way_wide_m;
  bool inside;  // the place lies in the map
  bool shaded;  // what enters was stored wherever something is
};

// A plane stays a plane under projection, so differences of depth between the texels around give the surface
// there, in the world, without the map's inverse.
void find_lit_point(inout LightRead r, MapLook m, MapRay ray, vec3 to_light, vec3 n_geometric) {
  const float z00 = m.z[0].y, z10 = m.z[1].x, z01 = m.z[2].z, z11 = m.z[3].w;
  const vec2 size = vec2(textureSize(shadow_depths, 0).xy), f = m.between;
  const float depth = mix(mix(z00, z10, f.x), mix(z01, z11, f.x), f.y);
  const vec2 slope = vec2(mix(z10 - z00, z11 - z01, f.y), mix(z01 - z00, z11 - z10, f.x)) * size * 0.5;
  const vec3 plane = (vec4(slope, -1.0, depth - dot(slope, ray.clip.xy / ray.clip.w)) * m.from_world)
                         .xyz;  // its normal, either way
  const float along = dot(plane, to_light);
  const float scale = (along < 0.0 ? -1.0 : 1.0) * inversesqrt(max(dot(plane, plane), 1e-30));
  r.way_m = max(way_of(ray, depth), 0.0);
  r.cosine = along * scale;
  r.facing = clamp(-dot(plane, n_geometric) * scale, 0.0, 1.0);
}

// Of four rays beside, `side` and its quarter turns away, texels. Where nothing is no light enters.
vec4 ways_beside(MapRay ray, MapLook m, vec2 side) {
  const vec2 size = vec2(textureSize(shadow_depths, 0).xy);
  vec4 way_m;
  for (int k = 0; k < 4; ++k) {
    const vec2 turned = (k & 1) == 0 ? side : vec2(-side.y, side.x);
    const vec2 texel = floor(m.uv * size + (k < 2 ? turned : -turned)) + 0.5;
    const float depth = textureLod(shadow_depths, vec3(texel / size, m.layer), 0.0).x;
    way_m[k] = depth > 0.0 ? way_of(ray, depth) : 1e3;
  }
  return way_m;
}

LightRead read_light(LightIo light, Arriving a, vec3 p, vec3 n_geometric, float cosine_here) {
  LightRead r = LightRead(1.0, vec3(0.0), 0.0, 0.0, 0.0, vec4(0.0), vec4(0.0), false, false);
  if (light.shadow_layers == 0u) return r;
  // Moved as in shadow_at() where the surface faces the light; what lies behind is measured from where it is.
  const float texel_m = shadow_texel_m(light, a);
  const vec3 q = cosine_here > 0.0 ? off_the_surface(p, n_geometric, a, texel_m, 2.5) : p;
  const MapLook m = look_into_map(light, q);
  r.inside = m.inside;
  if (!m.inside) return r;

  r.lit = share_lit(light, a, p, n_geometric, m);
  const MapRay ray = MapRay(m.clip, (m.from_world * vec4(a.to_light, 0.0)).zw);
  find_lit_point(r, m, ray, a.to_light, n_geometric);

  // Rays of the two terms lie on a cross and on its diagonals.
  const float near = transmission.two_sigma_m[term_before] / texel_m;
  const float wide = sqrt(0.5) * transmission.two_sigma_m[last_term] / texel_m;
  r.way_near_m = ways_beside(ray, m, vec2(near, 0.0));
  r.way_wide_m = ways_beside(ray, m, vec2(wide));

  r.entering = vec3(max(max(m.z[0].y, m.z[1].x), max(m.z[2].z, m.z[3].w)) > 0.0 ? 1.0 : 0.0);
  r.shaded = true;
  if (!entering_stored) return r;
  // Where something is too thin to show in a map of what enters that is smaller than the depths, all light
  // enters.
  const vec4 stored = textureLod(entering_maps, vec3(m.uv, m.layer), 0.0);
  if (stored.a > 1e-3) r.entering = (stored.rgb / stored.a) * (stored.rgb / stored.a);
  r.shaded = stored.a > 0.0 || m.z[0].y == 0.0;
  return r;
}

// What a light that is not far away sends to the lit point, relative to here.
float nearer_factor(LightIo light, Arriving a, LightRead r) {
  if (light.type == LIGHT_DIRECTIONAL) return 1.0;
  const float ratio = a.distance_m / max(a.distance_m - r.way_m, 0.01 * a.distance_m);
  return ratio * ratio;
}

// For each Gaussian, of light that crosses the map's plane: how much of it arrives. cosine_here < 0.
//
// Light from everywhere on the lit side to a point is, for a Gaussian of variance v, the mean of exp(-z^2 /
// 2v) over rays of the light that pass within a Gaussian of the same variance, z the way along each: exact on
// any lit surface. The wide terms, which see round a corner, take that mean over five rays (a rule exact to
// the third degree). Narrow ones take the lit side for a plane, and so do wide ones where both sides are
// parallel: then the mean is known.
//
// Near an edge the blur over the surface brings light round that these means hold as well. It hardly does
// where the lit point faces away from here; where it does not, the share that is new grows with the angle to
// the light. The figures were fitted to the reference.
void add_slab_factors(LightRead r, float cosine_here, vec3 light, inout vec3 through[TRANSMISSION_TERMS]) {
  // [DLE07]: thickness counts between sides that face away from each other, elsewhere the way of the light.
  const float d_m = r.way_m * mix(1.0, -cosine_here, r.facing);
  const float d2 = d_m * d_m, plane = smoothstep(0.97, 1.0, r.facing);
  const vec3 narrow = light * (r.cosine * r.facing);
  for (int i = 0; i < term_before; ++i) through[i] += narrow * exp(-d2 * transmission.falloff_per_m2[i]);
  const float is_new = mix(0.6 * smoothstep(0.0, 0.8, -cosine_here), 1.0, smoothstep(0.0, 0.5, r.facing));
  const float here2 = r.way_m * r.way_m;
  if (through_terms > 1) {
    const float falloff = transmission.falloff_per_m2[term_before];
    const float mean =
        0.5 * exp(-here2 * falloff) + dot(vec4(0.125), exp(-r.way_near_m * r.way_near_m * falloff));
    through[term_before] += light * (is_new * mix(mean, r.cosine * exp(-d2 * falloff), plane));
  }
  const float falloff = transmission.falloff_per_m2[last_term];
  const float mean =
      0.5 * exp(-here2 * falloff) + dot(vec4(0.125), exp(-r.way_wide_m * r.way_wide_m * falloff));
  through[last_term] += light * (is_new * mix(mean, r.cosine * exp(-d2 * falloff), plane));
}
