// SPDX-License-Identifier: MIT
// Shades eyes, teeth, brows, lashes: glTF 2.0 metallic-roughness (specification, appendix B) with GGX and
// height-correlated Smith. The environment is reflected by the split-sum fit of Karis, "Physically Based
// Shading on Mobile", 2014.
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/half.glsl"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
#include "render/shaders/frame.glsl"
layout(binding = 22) uniform sampler2DArray shadow_depths;
layout(binding = 8) uniform sampler2D map_base_colour;
layout(binding = 9) uniform sampler2D map_normal;
layout(binding = 10) uniform sampler2D map_roughness;
layout(binding = 11) uniform sampler2D map_occlusion;
layout(binding = 12) uniform sampler2D map_specular;
layout(binding = 13) uniform sampler2D map_emissive;
layout(binding = 14) uniform sampler2D map_specular_colour;
const float pi = 3.14159265358979;
#include "render/shaders/head.glsl"
#include "render/shaders/material.glsl"
#include "render/shaders/lights.glsl"
#include "render/shaders/environment.glsl"
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 5) in float in_plane_m;  // plane_distance()
layout(location = 0) out vec4 out_radiance;
layout(constant_id = 0) const bool layer = false;  // over skin that is not in the target

struct Look {
  vec3 albedo, f0;
  float f90, alpha, roughness;
};

Look look_at(ShadingPoint s, vec3 base) {
  float metallic = material.metallic, roughness = material.roughness;
  const MapIo mr = material.maps[MAP_ROUGHNESS];
  if (is_present(mr)) {
    const vec4 t = texture(map_roughness, map_uv(mr, s));
    roughness *= t.g;
    metallic *= t.b;
  }

  float specular = material.specular;
  const MapIo sm = material.maps[MAP_SPECULAR];
  if (is_present(sm)) specular *= texture(map_specular, map_uv(sm, s)).a;

  vec3 tint = material.specular_colour;
  const MapIo sc = material.maps[MAP_SPECULAR_COLOUR];
  if (is_present(sc)) tint *= texture(map_specular_colour, map_uv(sc, s)).rgb;

  const float r = (material.ior - 1.0) / (material.ior + 1.0);
  const vec3 dielectric = min(r * r * tint, vec3(1.0)) * specular;

  Look look;
  look.f0 = mix(dielectric, base, metallic);
  look.f90 = mix(specular, 1.0, metallic);
  look.albedo = base * (1.0 - metallic);
  look.roughness = clamp(roughness, 0.045, 1.0);
  look.alpha = look.roughness * look.roughness;
  return look;
}

vec3 brdf_times_cosine(Look look, vec3 n, vec3 v, vec3 l, float cosine) {
  const vec3 h = normalize(v + l);
  const float n_l = max(dot(n, l), 0.0), n_v = max(dot(n, v), 1e-3), n_h = max(dot(n, h), 0.0),
              v_h = max(dot(v, h), 0.0);
  const float a2 = look.alpha * look.alpha;
  const float d = n_h * n_h * (a2 - 1.0) + 1.0;
  const float distribution = a2 / (pi * d * d);
  const float visibility =
      0.5 / max(n_l * sqrt(n_v * n_v * (1.0 - a2) + a2) + n_v * sqrt(n_l * n_l * (1.0 - a2) + a2), 1e-5);
  const vec3 fresnel = look.f0 + (look.f90 - look.f0) * pow(1.0 - v_h, 5.0);
  const float kept = 1.0 - max(fresnel.x, max(fresnel.y, fresnel.z));
  vec3 sum = look.albedo * (kept / pi);
  if (is_on(frame.specular_on)) sum += fresnel * (distribution * visibility);
  return sum * cosine;
}

vec3 reflected_surroundings(Look look, float n_v) {
  const vec4 c0 = vec4(-1.0, -0.0275, -0.572, 0.022), c1 = vec4(1.0, 0.0425, 1.04, -0.04);
  const vec4 r = look.roughness * c0 + c1;
  const float a = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
  return max(look.f0 * (-1.04 * a + r.z) + look.f90 * (1.04 * a + r.w), vec3(0.0));
}

void main() {
  const vec3 v = view_vector(in_position_m);
  const ShadingPoint s = drawn_point(in_position_m, in_normal, in_plane_m, in_tangent, in_uv, in_colour,
                                     gl_FrontFacing ? 1.0 : -1.0);

  vec4 base = material.base_colour * in_colour;
  const MapIo bc = material.maps[MAP_BASE_COLOUR];
  if (is_present(bc)) base *= texture(map_base_colour, map_uv(bc, s));
  if (is_on(frame.white_albedo)) base.rgb = vec3(1.0);
  if (is_on(material.flags & MATERIAL_ALPHA_MASK) && base.a < material.alpha_cutoff) discard;

  const float alpha = is_on(material.flags & MATERIAL_ALPHA_BLEND) ? clamp(base.a, 0.0, 1.0) : 1.0;
  if (is_on(material.flags & MATERIAL_UNLIT)) {
    out_radiance = vec4(storable(base.rgb * alpha * frame.radiance_scale), 0.0);
    out_radiance.a = is_on(material.flags & MATERIAL_ALPHA_BLEND) ? alpha : 0.0;
    return;
  }

  Look look = look_at(s, base.rgb);
  look.albedo *= 1.0 - material.transmission;
  const vec3 n = mapped_normal(material.maps[MAP_NORMAL], map_normal, s);
  vec3 radiance = vec3(0.0);
  for (uint i = nothing(); i < frame.light_count; ++i) {
    const LightIo light = light_at(i);
    const Arriving a = arriving_light(light, s.position_m);
    const float tangent = light_tangent(light, a), cosine = light_cosine(dot(n, a.to_light), tangent);
    if (cosine <= 0.0) continue;
    Look seen = look;
    if (soft_shadows)
      seen.alpha =
          sqrt(min(look.alpha * look.alpha + tangent * tangent / 8.0, 1.0));  // as for the lobes of skin
    radiance += a.irradiance * brdf_times_cosine(seen, n, v, a.to_light, cosine) * shadow_at(light, a, s);
  }

  const MapIo oc = material.maps[MAP_OCCLUSION];
  const float occlusion =
      is_present(oc) ? 1.0 + oc.scale * (texture(map_occlusion, map_uv(oc, s)).r - 1.0) : 1.0;
  const vec3 mirrored =
      is_on(frame.specular_on) ? reflected_surroundings(look, max(dot(n, v), 0.0)) : vec3(0.0);
  const vec3 diffuse =
      surroundings_irradiance(n) / pi * look.albedo * (1.0 - max(mirrored.x, max(mirrored.y, mirrored.z)));
  radiance += occlusion * (diffuse + surroundings_radiance(reflect(-v, n), look.alpha) * mirrored);

  vec3 emitted = material.emissive;
  const MapIo em = material.maps[MAP_EMISSIVE];
  if (is_present(em)) emitted *= texture(map_emissive, map_uv(em, s)).rgb;
  radiance += emitted;

  // Colour is premultiplied. Alpha of the target marks skin: opaque parts write 0. Of a layer alpha is what
  // it hides.
  out_radiance = vec4(storable(radiance * alpha * frame.radiance_scale), layer ? 1.0 : 0.0);
  const float passes = material.transmission * dot(base.rgb, vec3(1.0 / 3.0)) *
                       (1.0 - max(mirrored.x, max(mirrored.y, mirrored.z)));
  if (is_on(material.flags & MATERIAL_ALPHA_BLEND)) out_radiance.a = alpha * (1.0 - passes);
}
