// SPDX-License-Identifier: MIT
// Light that comes through the body. One read of a light's map serves both of its uses. Where the surface
// faces the light, that is the share that arrives; where it faces away, place and angle at which transmitted
// light has entered. Translucent shadow maps; docs/techniques.md explains the design. Based on: [SD03]
// Dachsbacher, Stamminger: Translucent Shadow Maps, EGSR 2003 (entering light is part of the shadow map, and
// is gathered in the light's view). [DLE07] GPU Gems 3, ch. 14.5 (thickness with the normals' correction).
// Follows skin_point.glsl.
#include "render/shared/terms_io.h"
layout(binding = 23) uniform sampler2DArray entering_maps;
#ifndef TRANSMISSION  // a pass may have it elsewhere
layout(binding = 24, scalar) uniform Transmission { TransmissionIo transmission; };
#endif
layout(constant_id = 8) const int through_terms = 6;

#ifndef THROUGH_RAYS  // false: of no more than narrow terms
#define THROUGH_RAYS true
#endif
const int last_term = through_terms - 1,
          term_before = through_terms > 1 ? through_terms - 2 : 0;  // both use rays around the ray of light

layout(constant_id = 19) const bool slab_gains = false;      // the profile knows what slabs let through
layout(constant_id = 15) const bool entering_stored = true;  // else all light enters at any surface

struct LightRead {
  float lit;      // 0..1, where the surface faces the light: as shadow_at()
  vec3 entering;  // albedo^mix of the skin at the lit point; 0 where the first thing that light meets is no
                  // skin
  float cosine;   // of the light, there
  float facing;   // 0..1: how far the lit point faces away from here
  float way_m;    // distance from there to here, along the light
  // The same along parallel rays, two sigma of the last but one and of the last term away; no light: far.
  vec4 way_near_m, way_wide_m;  // 0 where the surface here faces the light
  bool inside;                  // the position lies in the map
  bool shaded;                  // entering light was stored wherever there is a surface
};

// Of the four texels around the lit point, in the order (0,0) (1,0) (0,1) (1,1).
struct FirstSurfaces {
  vec4 depth;     // 0 where there is none
  vec4 share;     // of each in what is read between them, 0 where no light enters
  vec3 entering;  // as LightRead has it
  bool shaded;
};

// Each texel decides whether light enters. The back of a surface, which light meets inside a bust or a mask,
// lets none in. Its depth, often that of the very point that is lit, must not be mixed with others. Nothing
// is read where the surface faces the light, as in look_beside().
FirstSurfaces first_surfaces(MapLook m, MapRay ray, float texel_m, bool faces) {
  const vec2 f = m.between, base = floor(m.here - 0.5);
  FirstSurfaces s;
  s.depth = vec4(m.z[0].y, m.z[1].x, m.z[2].z, m.z[3].w);
  s.share = vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
  s.share *= vec4(greaterThan(s.depth, vec4(0.0)));
  s.entering = vec3(0.0);
  s.shaded = true;

  const float surface = dot(s.share, vec4(1.0));
  const int texels = faces || !entering_stored ? 0 : 4;
  for (int k = 0; k < texels; ++k) {
    const vec2 at = base + vec2(k & 1, k >> 1) + 0.5;
    const vec4 stored = textureLod(entering_maps, in_layer(at, m.layer), 0.0);
    const vec3 root = stored.rgb / max(stored.a, 1e-3);
    s.shaded = s.shaded && (stored.a > 0.0 || s.depth[k] == 0.0);
    // Behind the point, but for the rounding of a slope, a surface is another part.
    const float before = smoothstep(-6.0, -2.0, way_of(ray, s.depth[k]) / texel_m);
    s.share[k] *= max(root.r, max(root.g, root.b)) > 0.0 ? before : 0.0;
    s.entering += s.share[k] * root * root;
  }
  s.entering /= max(surface, 1e-6);
  return s;
}

// Finds the surface at the lit point, in the world and without the inverse of the map's matrix. A plane stays
// a plane under projection, so differences of depth between neighbouring texels give it.
void find_lit_point(inout LightRead r, MapLook m, FirstSurfaces s, MapRay ray, vec3 to_light,
                    vec3 n_geometric) {
  const vec2 f = m.between;
  const float share = dot(s.share, vec4(1.0));
  const float depth = dot(s.share, s.depth) / max(share, 1e-6);
  const vec2 slope = vec2(mix(s.depth.y - s.depth.x, s.depth.w - s.depth.z, f.y),
                          mix(s.depth.z - s.depth.x, s.depth.w - s.depth.y, f.x)) *
                     m.side * 0.5;
  const vec3 plane = (vec4(slope, -1.0, depth - dot(slope, ray.clip.xy / ray.clip.w)) * m.from_world)
                         .xyz;  // its normal, either way
  const float along = dot(plane, to_light);
  const float scale = (along < 0.0 ? -1.0 : 1.0) * inversesqrt(max(dot(plane, plane), 1e-30));
  r.way_m = max(way_of(ray, depth), 0.0);
  r.cosine = along * scale;
  r.facing = clamp(-dot(plane, n_geometric) * scale, 0.0, 1.0);
}

// Returns the distance along a ray beside that of the light, in texels. Where there is no surface, or its
// back, or outside the map, no light enters.
float way_beside(MapRay ray, MapLook m, vec2 side) {
  const vec2 at = floor(m.here + side) + 0.5;
  const bool known = all(greaterThan(at, vec2(0.0))) && all(lessThan(at, vec2(m.side)));
  const vec3 texel = in_layer(at, m.layer);
  const float depth = textureLod(shadow_depths, texel, 0.0).x;
  const bool enters = !entering_stored || textureLod(entering_maps, texel, 0.0).r > 0.0;
  return known && depth > 0.0 && enters ? way_of(ray, depth) : 1e3;
}

// Finds the distances along four rays of each of both terms, `near` and `wide` and their quarter turns away,
// in texels. Nothing is read where the surface faces the light: the loop then ends before its first turn.
// That saves time on a software device, too, which computes both sides of an `if`.
void look_beside(inout LightRead r, MapRay ray, MapLook m, vec2 near, vec2 wide, bool faces) {
  const int rays = faces || !THROUGH_RAYS ? 0 : 4;
  for (int k = 0; k < rays; ++k) {
    const bvec4 this_one = equal(ivec4(0, 1, 2, 3), ivec4(k));
    r.way_near_m = mix(r.way_near_m, vec4(way_beside(ray, m, near)), this_one);
    r.way_wide_m = mix(r.way_wide_m, vec4(way_beside(ray, m, wide)), this_one);
    near = vec2(-near.y, near.x);
    wide = vec2(-wide.y, wide.x);
  }
}

LightRead read_light(LightIo light, Arriving a, ShadingPoint s, float cosine_here) {
  LightRead r = LightRead(1.0, vec3(0.0), 0.0, 0.0, 0.0, vec4(0.0), vec4(0.0), false, false);
  if (light.shadow_layers == 0u) return r;
  // Moved as in shadow_at() where the surface faces the light; distances behind are measured from the point
  // itself.
  const float texel_m = shadow_texel_m(light, a);
  const vec3 q = cosine_here > 0.0 ? shadow_point(s, a, texel_m) : s.shadow_m;
  const MapLook m = look_into_map(light, q, s.normal, a.to_light);
  r.inside = m.inside;
  if (!m.inside) return r;

  r.lit = share_lit(light, a, s, m);
  const MapRay ray = MapRay(m.clip, (m.from_world * vec4(a.to_light, 0.0)).zw);
  const FirstSurfaces first = first_surfaces(m, ray, texel_m, cosine_here > 0.0);
  find_lit_point(r, m, first, ray, a.to_light, s.normal);

  // The rays of the two terms form a cross and its diagonals.
  const float near = transmission.two_sigma_m[term_before] / texel_m;
  const float wide = sqrt(0.5) * transmission.two_sigma_m[last_term] / texel_m;
  look_beside(r, ray, m, vec2(near, 0.0), vec2(wide), cosine_here > 0.0);

  r.entering = first.entering;
  r.shaded = first.shaded;
  if (entering_stored) return r;
  // Of a host's map only the depth is known. A surface that faces away and yet is the first that light meets
  // is the inside of an open mesh: no body lies between.
  const bool whole = all(greaterThan(first.depth, vec4(0.0)));  // else the way is not known so well
  const float crossed = whole ? smoothstep(0.02, 0.1, r.way_m / texel_m) : 1.0;
  r.entering = vec3(any(greaterThan(first.depth, vec4(0.0))) ? crossed : 0.0);
  return r;
}

// Returns the irradiance of a near light at the lit point, relative to here.
float nearer_factor(LightIo light, Arriving a, LightRead r) {
  if (light.type == LIGHT_DIRECTIONAL) return 1.0;
  const float ratio = a.distance_m / max(a.distance_m - r.way_m, 0.01 * a.distance_m);
  return ratio * ratio;
}

// Returns the gain at a thickness, between those that are stored.
vec3 slab_gain(float thickness_m) {
  const float last = float(TRANSMISSION_GAINS - 1);
  const float x = min(sqrt(thickness_m * transmission.gains_end_per_m), 1.0) * last;
  const int i = min(int(x), TRANSMISSION_GAINS - 2);
  return mix(transmission.gain[i], transmission.gain[i + 1], x - float(i));
}

// Adds, per Gaussian, the part of the light crossing the map's plane that arrives. cosine_here < 0.
//
// For a Gaussian of variance v, all the light of the lit side that reaches a point is a mean of exp(-z^2 /
// 2v). It goes over rays of the light within a Gaussian of the same variance, with z the distance along each.
// It is exact on any lit surface. The wide terms, which reach around corners, take that mean over five rays
// (a rule exact to the third degree). Narrow ones take the lit side for a plane, and so do wide ones where
// both sides are parallel: then the mean is known. Without THROUGH_RAYS all do.
//
// Near an edge the blur over the surface already brings light to where these means hold too. It hardly does
// where the lit point faces away from here; elsewhere the share that is not yet counted grows with the angle
// to the light. The figures are fitted to the reference.
void add_slab_factors(LightRead r, float cosine_here, vec3 light, inout vec3 through[MOST_TERMS]) {
  // [DLE07]: thickness between sides that face away from each other, elsewhere the distance along the light.
  const float d_m = r.way_m * mix(1.0, -cosine_here, r.facing);
  // A slab's gain holds where the sides face away from each other, and not for a chord beside the terminator.
  if (slab_gains) light *= mix(vec3(1.0), slab_gain(d_m), smoothstep(0.3, 0.9, r.facing));
  const float d2 = d_m * d_m, plane = smoothstep(0.97, 1.0, r.facing);
  const vec3 narrow = light * (r.cosine * r.facing);
  const int planes = THROUGH_RAYS ? term_before : through_terms;
  for (int i = 0; i < planes; ++i) through[i] += narrow * exp(-d2 * transmission.falloff_per_m2[i]);
  if (!THROUGH_RAYS) return;

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

// As LitSkin, and transmitted light that arrives at the point.
struct LitThrough {
  LitSkin skin;
  vec3 through[MOST_TERMS];  // per Gaussian: irradiance of the far side, times its albedo^mix
                             // and the Gaussian's slab factor
};

// Where the surface faces a light it is lit by it, or lies in a shadow that the light may have passed through
// air: nothing is transmitted. Where it faces away none of that light enters. So no light counts twice.
LitThrough lit_through(ShadingPoint s, vec3 n, SkinSpecular spec, SkinView view) {
  const float kept_mean = 1.0 - specular_albedo_mean(directional_albedo, spec);
  LitThrough r;
  r.skin = LitSkin(vec3(0.0), vec3(0.0));
  for (int i = 0; i < through_terms; ++i) r.through[i] = vec3(0.0);

  for (uint k = nothing(); k < frame.light_count; ++k) {
    const LightIo light = light_at(k);
    const Arriving a = arriving_light(light, s.position_m);
    const float cosine_here = dot(s.normal, a.to_light);
    const LightRead read = read_light(light, a, s, cosine_here);
    const float tangent = light_tangent(light, a);

    const bool faces = cosine_here > 0.0;
    const float cosine_lit = light_cosine(dot(n, a.to_light), tangent),
                cosine = faces ? cosine_lit : read.cosine;
    const vec3 kept = a.irradiance * ((1.0 - specular_albedo(directional_albedo, spec, cosine)) / kept_mean);
    if (faces)
      r.skin.entering += kept * (cosine_lit * read.lit);
    else if (soft_shadows && cosine_here > -tangent)
      r.skin.entering +=
          a.irradiance *
          (cosine_lit * read.lit * (1.0 - specular_albedo(directional_albedo, spec, cosine_lit)) / kept_mean);
    if (faces)
      r.skin.reflected += a.irradiance * (reflected_share(view, spec, light, a, s.normal) * read.lit);

    // While a light sets, its transmitted light fades in.
    const float set = tangent > 0.0 ? min(-cosine_here / tangent, 1.0) : 1.0;
    add_slab_factors(read, cosine_here,
                     kept * read.entering * (faces ? 0.0 : set * nearer_factor(light, a, read)), r.through);
  }
  return r;
}

// Returns the part that joins the light map before the terms of a group:
// render/passes/light_map/transmission.h.
vec3 joining(LitThrough r, int group) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < through_terms; ++i) sum += transmission.share[group * MOST_TERMS + i] * r.through[i];
  return sum;
}

// Returns sum_i w_i T_i, where no term is read from a map: terms of a group share their mean, as in maps.
vec3 all_through(LitThrough r) {
  vec3 sum = vec3(0.0), mean = vec3(0.0);
  for (int g = 0; g < TRANSMISSION_GROUPS; ++g) {
    mean += joining(r, g);
    sum += transmission.group_weight[g] * mean;
  }
  return sum;
}

// Returns for how many lights that a point faces away from the position is outside the light's map, or
// entering light was not stored although there is a surface.
uint transmission_misses(ShadingPoint s) {
  uint misses = 0u;
  for (uint k = nothing(); k < frame.light_count; ++k) {
    const LightIo light = light_at(k);
    const Arriving a = arriving_light(light, s.position_m);
    const float cosine_here = dot(s.normal, a.to_light);
    const LightRead read = read_light(light, a, s, cosine_here);
    if (cosine_here <= 0.0 && light.shadow_layers > 0u && !(read.inside && read.shaded)) ++misses;
  }
  return misses;
}
