// SPDX-License-Identifier: MIT
// What the eye sees of the skin: the scattered light of its texels (or, with no terms, the light that enters at the pixel), the part of
// the albedo that is applied after, and the two lobes of the specular. Alpha 1 marks skin.
#version 460
#include "passes/skin/skin_io.h"
#include "shared/half.glsl"
#include "shared/scene_io.h"
#include "shared/skin_point.glsl"
layout(constant_id = 0) const int term_count = 6;
layout(constant_id = 1) const bool direct = false;  // what the weights leave of 1 is lit here instead
layout(push_constant, scalar) uniform Push { SkinIo io; };
layout(binding = 14) uniform sampler2D light_0;
layout(binding = 15) uniform sampler2D light_1;
layout(binding = 16) uniform sampler2D light_2;
layout(binding = 17) uniform sampler2D light_3;
layout(binding = 18) uniform sampler2D light_4;
layout(binding = 19) uniform sampler2D light_5;
layout(binding = 20) uniform sampler2D light_6;
layout(binding = 21) uniform sampler2D light_7;
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
// Centroid: beside a silhouette or a seam the pixel's centre may lie off the triangle, and the map there may hold nothing.
layout(location = 5) centroid in vec2 in_unwrap;
layout(location = 6) flat in vec4 in_unwrap_box;
layout(location = 0) out vec4 out_radiance;

#include "passes/skin/light_point.glsl"

// sum_i w_i (light blurred by term i), already times 2^EV / pi.
vec3 scattered() {
  const vec2 at = light_point(in_unwrap, in_unwrap_box) / vec2(textureSize(light_0, 0));
  vec3 sum = vec3(0.0);
  if (term_count > 0) sum += io.weights[0] * textureLod(light_0, at, 0.0).rgb;
  if (term_count > 1) sum += io.weights[1] * textureLod(light_1, at, 0.0).rgb;
  if (term_count > 2) sum += io.weights[2] * textureLod(light_2, at, 0.0).rgb;
  if (term_count > 3) sum += io.weights[3] * textureLod(light_3, at, 0.0).rgb;
  if (term_count > 4) sum += io.weights[4] * textureLod(light_4, at, 0.0).rgb;
  if (term_count > 5) sum += io.weights[5] * textureLod(light_5, at, 0.0).rgb;
  if (term_count > 6) sum += io.weights[6] * textureLod(light_6, at, 0.0).rgb;
  if (term_count > 7) sum += io.weights[7] * textureLod(light_7, at, 0.0).rgb;
  return sum;
}

vec3 specular_radiance(SurfacePoint s, vec3 n, vec3 n_geometric, vec3 v, SkinSpecular spec) {
  if (spec.rho_s <= 0.0) return vec3(0.0);
  vec3 sum = vec3(0.0);
  for (uint i = 0u; i < frame.light_count; ++i) {
    const LightIo light = lights[i];
    const Arriving a = arriving_light(light, s.position_m);
    const float cosine = dot(n, a.to_light);
    if (cosine <= 0.0 || dot(n_geometric, a.to_light) <= 0.0) continue;
    sum += a.irradiance * (cosine * specular_brdf(spec, n, v, a.to_light) * shadow_at(light, a, s.position_m, n_geometric));
  }
  // A uniform surrounding is reflected by the lobe's albedo.
  return sum + frame.ambient * (specular_albedo(attenuation, spec, dot(n, v)) * skin_occlusion(s));
}

void main() {
  const vec3 v = frame.orthographic != 0u ? -frame.view_direction : normalize(frame.eye_m - in_position_m);
  const vec3 n_interpolated = normalize(in_normal);
  const vec3 n_geometric = gl_FrontFacing ? n_interpolated : -n_interpolated;
  const SurfacePoint s = SurfacePoint(in_position_m, n_geometric, in_tangent, in_uv.xy, in_uv.zw, in_colour);
  vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
  const SkinSpecular spec = skin_specular(s);
  const vec3 albedo = skin_albedo(s);
  vec3 diffuse = vec3(0.0);
  if (term_count > 0) diffuse = scattered() * albedo_power(albedo, 1.0 - material.mix_before);
  if (direct) {
    vec3 share = vec3(1.0);
    for (int i = 0; i < term_count; ++i) share -= io.weights[i];
    diffuse += share * entering_irradiance(s, n, n_geometric, spec) * albedo * (frame.radiance_scale / pi);
  }
  // A mapped normal may face away from the eye at a silhouette; seen surfaces have a positive cosine.
  const float n_v = dot(n, v);
  if (n_v < 0.05) n = normalize(n + v * (0.05 - n_v));
  diffuse *= 1.0 - specular_albedo(attenuation, spec, dot(n, v));
  const vec3 radiance = diffuse + specular_radiance(s, n, n_geometric, v, spec) * frame.radiance_scale;
  out_radiance = vec4(storable(radiance), 1.0);
}
