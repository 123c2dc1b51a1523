// SPDX-License-Identifier: MIT
// Light from the skin to the camera: the scattered light of its texels, the part
// of the albedo that is applied afterwards, two specular lobes, and emission. With no terms, the light that
// enters at the pixel stands for that of texels. THROUGH: with transmitted light. Needs `io` (ShadeIo).
#include "render/shaders/skin_answer.glsl"
#include "render/shaders/map_read.glsl"
#ifdef THROUGH
#define THROUGH_RAYS (io.through_rays != 0u)
#include "render/shaders/transmission.glsl"
#endif
layout(constant_id = 0) const int term_count = 6;
layout(constant_id = 1) const bool direct = false;  // the rest of the weights to 1 is lit per pixel
// One of the terms is the light before any blur, for the narrow terms: no light comes through the body there.
layout(constant_id = 25) const int entered_term = -1;
layout(binding = 14) uniform sampler2D light_0;
layout(binding = 15) uniform sampler2D light_1;
layout(binding = 16) uniform sampler2D light_2;
layout(binding = 17) uniform sampler2D light_3;
layout(binding = 18) uniform sampler2D light_4;
layout(binding = 19) uniform sampler2D light_5;
layout(binding = 20) uniform sampler2D light_6;
layout(binding = 21) uniform sampler2D light_7;

layout(constant_id = 14) const bool mixed = false;  // true: what it can't hold is lit at the pixel
#ifndef TERMS                                       // a pass may have it elsewhere
layout(binding = 31, scalar) uniform Terms { SkinTermsIo terms; };
#endif

uvec2 map_origin() { return uvec2(io.map_origin & 0xFFFFu, io.map_origin >> 16); }

// Returns the position of an unwrap coordinate in the pool of light maps, texels: in the square of the head,
// with its bilinear footprint. In steps of 1/256 texel, to which samplers round anyway: the sum is exact
// then, so that a head has the same bits in every square. Half a texel and one step inside: outside the
// square there may be NaN, which a weight of 0 does not remove.
vec2 light_point(vec2 unwrap) {
  const float steps = 256.0, margin = 0.5 + 1.0 / steps;
  const vec2 in_steps = floor(unwrap * (float(io.side) * steps) + 0.5) / steps;
  return clamp(in_steps, margin, float(io.side) - margin) + vec2(map_origin());
}

// Returns the offset of the unwrap coordinates at which skin reads its light. Light towards the eye came up
// along the refracted ray, from below a place further away from the eye (ShapeLaws::exit_offset_mm).
// border_mm: of body_shape(). n, to_eye: unit.
vec2 exit_offset(AlongSkin along, float border_mm, vec3 n, vec3 to_eye) {
  // Beside an open border there is no light. Ways along edges are longer than straight ones.
  const float offset_m = min(terms.exit_offset_m, 0.7 * border_mm * terms.m_per_mm);
  const vec3 away_m = (n * dot(n, to_eye) - to_eye) * offset_m;
  return vec2(dot(along.u, away_m), dot(along.v, away_m));
}

// Returns how much more or less light leaves than from a flat half-space: curved_total() and slab_front() of
// tissue/profile/shape_laws.h, and the exit of ShapeLaws. shape: mean and half difference of the principal
// curvatures per mm, thickness in mm. cosine: of the angle of exit.
vec3 shape_factor(vec3 shape, float cosine) {
  const vec3 bend = shape.x > 0.0 ? terms.shape.convex_mm : -terms.shape.concave_mm;
  const vec3 below = max(1.0 + bend * shape.x + terms.shape.difference_mm * shape.y, 0.5);
  const vec3 total = clamp(
      1.0 + terms.shape.curvature_mm * shape.x / below + terms.shape.difference_mm2 * (shape.y * shape.y),
      0.3, 2.5);
  const vec3 front = 1.0 - terms.shape.front_share * exp(-shape.z * terms.shape.front_per_mm);
  const float c = clamp(cosine, 0.0, 1.0);
  return total * front * (terms.shape.exit_grazing + terms.shape.exit_change * (c * c));
}

// Returns whether a term is read from its map. One without weight may not have been written: 0 times NaN is
// NaN.
bool is_read(int i) { return i < term_count && (!direct || io.weights[i] != vec3(float(nothing()))); }

// Returns the part of a term that is read from its map.
vec3 mapped_weight(int term, OnMap on) {
  if (!mixed) return io.weights[term];
  return map_share(terms.sigma_mm[term], io.shown_mm, on.uv_per_mm, io.side) * io.weights[term];
}

vec3 light_of(sampler2D light, vec2 at) {
  return cut_out ? light_left(light, at) : textureLod(light, at, 0.0).rgb;
}

// Returns sum_i w_i (light blurred by term i), already times 2^EV / pi, with the weights of `on`, where it
// lies at `unwrap`.
vec3 scattered(OnMap on, vec2 unwrap) {
  const vec2 at = light_point(unwrap) / vec2(textureSize(light_0, 0));
  vec3 sum = vec3(0.0);
  if (is_read(0)) sum += mapped_weight(0, on) * light_of(light_0, at);
  if (is_read(1)) sum += mapped_weight(1, on) * light_of(light_1, at);
  if (is_read(2)) sum += mapped_weight(2, on) * light_of(light_2, at);
  if (is_read(3)) sum += mapped_weight(3, on) * light_of(light_3, at);
  if (is_read(4)) sum += mapped_weight(4, on) * light_of(light_4, at);
  if (is_read(5)) sum += mapped_weight(5, on) * light_of(light_5, at);
  if (is_read(6)) sum += mapped_weight(6, on) * light_of(light_6, at);
  if (is_read(7)) sum += mapped_weight(7, on) * light_of(light_7, at);
  return sum;
}

#ifdef THROUGH
// Returns the transmitted light that the maps would show, for the part of the terms lit here: terms of a
// group share their mean.
vec3 through_share(LitThrough r, OnMap on) {
  vec3 sum = vec3(0.0), mean = vec3(0.0);
  for (int g = 0; g < TRANSMISSION_GROUPS; ++g) {
    mean += joining(r, g);
    vec3 share = transmission.group_weight[g];
    for (int i = 0; i < term_count; ++i)
      if (i != entered_term && transmission.group[terms.first_mapped + uint(i)] == uint(g))
        share -= mapped_weight(i, on);
    sum += share * mean;
  }
  return sum;
}

LitThrough found_through;  // at the first point of an entry
#endif

// s.normal: interpolated, turned to the side that is seen. The result can be stored in half floats.
// `again`: at the second point of an entry, to which the same light comes through.
vec3 skin_radiance(ShadingPoint s, OnMap on, bool again) {
  const vec3 v = view_vector(s.position_m);
  const vec3 n = skin_normal(s);
  const SkinSpecular spec = skin_specular(s);
  const SkinView view = skin_view(n, v, spec);
  const vec3 albedo = skin_albedo(s);
#ifdef THROUGH
  if (!again) found_through = lit_through(s, n, spec, view);
  const LitSkin lit = again ? lit_skin(s, n, spec, true, view) : found_through.skin;
#else
  const LitSkin lit = lit_skin(s, n, spec, direct, view);
#endif

  vec3 diffuse = vec3(0.0);
  if (term_count > 0) {
    const vec2 from = shape_aware ? exit_offset(on.along, on.shape.w, s.normal, v) : vec2(0.0);
    diffuse = scattered(on, on.unwrap + from) * albedo_power(albedo, 1.0 - material.mix_before);
  }
  if (direct) {
    vec3 share = vec3(1.0);
    for (int i = 0; i < term_count; ++i) share -= mapped_weight(i, on);
    const vec3 entering = lit.entering + entering_surroundings(s, n, on.unwrap);
    vec3 leaving = share * entering * albedo;
#ifdef THROUGH
    leaving += through_share(found_through, on) * albedo_power(albedo, 1.0 - material.mix_before);
#endif
    diffuse += leaving * (frame.radiance_scale / pi);
  }

  if (shape_aware) diffuse *= shape_factor(on.shape.xyz, dot(s.normal, v));
  const vec3 surroundings = mirrored_surroundings(s, on.unwrap, view, spec, diffuse / frame.radiance_scale);
  diffuse *= 1.0 - specular_albedo(directional_albedo, spec, dot(view.n, v));
  vec3 radiance = diffuse + (lit.reflected + surroundings) * frame.radiance_scale;
  if (emits) radiance += emitted(s) * frame.radiance_scale;
  return storable(radiance);
}
