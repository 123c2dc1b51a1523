// SPDX-License-Identifier: MIT
// Material of a point of skin, the light that enters there and what is reflected to the eye. The pass in
// texture space and direct shading per pixel share it, so that both show the same skin. Buffers are uniform,
// not storage: some software devices read zeros from storage in helper invocations, which breaks texture
// derivatives.
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
layout(binding = 22) uniform sampler2DArray shadow_depths;
layout(binding = 7) uniform sampler2D directional_albedo;
layout(binding = 8) uniform sampler2D map_base_colour;
layout(binding = 9) uniform sampler2D map_normal;
layout(binding = 10) uniform sampler2D map_roughness;
layout(binding = 11) uniform sampler2D map_occlusion;
layout(binding = 12) uniform sampler2D map_specular;
// Over the unwrap, in the asset's coordinates: environment/occlusion.h.
layout(binding = 27) uniform sampler2D bent_normal;
// Likewise, environment::SkyLight: what is direct, what has bounced.
layout(binding = 29) uniform sampler2DArray sky_light;
layout(constant_id = 13) const
    bool off_map = false;  // the point is not on the unwrap: its occlusion is not known

#include "render/shaders/specular.glsl"
#include "render/shaders/material.glsl"
#include "render/shaders/lights.glsl"
#include "render/shaders/environment.glsl"

vec3 skin_albedo(ShadingPoint s) {
  if (is_on(frame.white_albedo)) return vec3(1.0);
  vec3 albedo = material.base_colour.rgb * s.colour.rgb;
  const MapIo map = material.maps[MAP_BASE_COLOUR];
  if (is_present(map)) albedo *= map_texel(map_base_colour, map, s).rgb;
  return max(albedo, vec3(0.0));
}

// Returns albedo^exponent. [DLE07] sec. 3.4 splits the albedo before and after scattering; mix 0.5 is an
// absorbing sheet crossed twice.
vec3 albedo_power(vec3 albedo, float exponent) {
  if (exponent <= float(nothing())) return vec3(1.0);
  return pow(max(albedo, vec3(1e-6)), vec3(exponent));
}

SkinSpecular skin_specular(ShadingPoint s) {
  SkinSpecular spec;
  spec.rho_s = is_on(frame.specular_on) ? material.rho_s : 0.0;
  const MapIo specular_map = material.maps[MAP_SPECULAR];
  if (is_present(specular_map))
    spec.rho_s *= specular_map.scale * map_texel(map_specular, specular_map, s)[specular_map.channel];
  float roughness = material.roughness;
  const MapIo roughness_map = material.maps[MAP_ROUGHNESS];
  if (is_present(roughness_map))
    roughness = roughness_map.scale * map_texel(map_roughness, roughness_map, s)[roughness_map.channel];
  const float m = clamp(roughness * roughness, 0.02, 1.0);
  spec.f0 = f0_of_ior(material.ior);
  spec.m = clamp(m * vec2(material.lobe_factor_0, material.lobe_factor_1), vec2(0.02), vec2(1.0));
  spec.weight = vec2(material.lobe_weight_0, material.lobe_weight_1);
  return spec;
}

float skin_occlusion(ShadingPoint s) {
  const MapIo map = material.maps[MAP_OCCLUSION];
  return is_present(map) ? 1.0 + map.scale * (map_texel(map_occlusion, map, s).r - 1.0) : 1.0;
}

const float least_open = 0.002;  // lower bound: white skin in a closed hole has no solution

// Returns the visible share of the sky.
float skin_open(ShadingPoint s, vec2 unwrap) {
  return environment && !off_map ? clamp(textureLod(bent_normal, unwrap, 0.0).w, least_open, 1.0) *
                                       max(skin_occlusion(s), least_open)
                                 : skin_occlusion(s);
}

// Returns the irradiance that enters from the environment; its reflected part and the division by the mean
// cancel. Under a picture, occluders reflect their own light over any number of bounces, as white skin in a
// white environment stays white. Occluders of a painted map are lit as the point itself: a geometric series
// of the albedo. Based on: Stewart, Langer: Toward Accurate Recovery of Shape from Shading Under Diffuse
// Lighting, PAMI 19(9), 1997.
vec3 entering_surroundings(ShadingPoint s, vec3 n, vec2 unwrap) {
  if (!environment || off_map) return surroundings_irradiance(n) * skin_occlusion(s);
  // The maps hold the normal of the mesh; a mapped normal faces another part of the sky.
  const vec4 in_asset = textureLod(bent_normal, unwrap, 0.0),
             bounced = textureLod(sky_light, vec3(unwrap, 1.0), 0.0);
  const vec4 seen = vec4(world_direction(in_asset.xyz), in_asset.w);
  const vec3 mapped = surroundings_irradiance(normalize(n + seen.xyz)),
             unmapped = surroundings_irradiance(normalize(s.normal + seen.xyz));
  const vec3 direct = textureLod(sky_light, vec3(unwrap, 0.0), 0.0).rgb;
  vec3 e = max(direct * frame.environment_intensity + (mapped - unmapped) * seen.w, vec3(0.0));
  e += mapped * max(least_open - seen.w, 0.0);
  const vec3 albedo = min(skin_albedo(s), vec3(1.0));
  e += bounced.rgb * frame.environment_intensity * albedo * bounced.w / (1.0 - albedo * (1.0 - bounced.w));
  const float painted = max(skin_occlusion(s), least_open);
  return e * (painted / (1.0 - albedo * (1.0 - painted)));
}

// The view of a point of skin.
struct SkinView {
  bool reflects;  // false: nobody looks at it, or nothing is reflected
  vec3 n;         // unit, as mapped_normal(), turned towards the eye where it faces away
  vec3 to_eye;    // unit
};
const SkinView unseen = SkinView(false, vec3(0.0), vec3(0.0));

SkinView skin_view(vec3 n, vec3 to_eye, SkinSpecular spec) {
  // A mapped normal may face away from the camera at a silhouette; visible surfaces have a positive cosine.
  const float n_v = dot(n, to_eye);
  if (n_v < 0.05) n = normalize(n + to_eye * (0.05 - n_v));
  return SkinView(spec.rho_s > 0.0, n, to_eye);
}

struct LitSkin {
  vec3 entering;   // irradiance
  vec3 reflected;  // radiance
};

// Returns the radiance that a light's unit irradiance on a facing surface leads to the eye, unshadowed; 0
// where it does not face the light.
float reflected_share(SkinView view, SkinSpecular spec, LightIo light, Arriving a, vec3 n_geometric) {
  const float cosine = dot(view.n, a.to_light);
  if (!view.reflects || cosine <= 0.0 || dot(n_geometric, a.to_light) <= 0.0) return 0.0;
  // A disc widens the lobes: slopes of the half vector vary by a sixteenth of tangent^2, those of the surface
  // by m^2 / 2.
  if (soft_shadows)
    spec.m = min(sqrt(spec.m * spec.m + light_tangent(light, a) * light_tangent(light, a) / 8.0), vec2(1.0));
  return cosine * specular_brdf(spec, view.n, view.to_eye, a.to_light);
}

// Sums over the lights. The shadow of each, which costs more than the rest, is evaluated once for what
// enters and what is reflected. enters: whether the light that enters is wanted. It is without what the
// surface reflects. The division by its mean over all directions here, where light enters, keeps a white
// furnace white, also with maps that vary: (1-rho(L)) (1-rho(V)) / (1-rho_mean).
LitSkin lit_skin(ShadingPoint s, vec3 n, SkinSpecular spec, bool enters, SkinView view) {
  LitSkin sum = LitSkin(vec3(0.0), vec3(0.0));
  for (uint i = nothing(); i < frame.light_count; ++i) {
    const LightIo light = light_at(i);
    const Arriving a = arriving_light(light, s.position_m);
    const float reflected = reflected_share(view, spec, light, a, s.normal);
    const float tangent = light_tangent(light, a), cosine = light_cosine(dot(n, a.to_light), tangent);
    const bool entered = enters && cosine > 0.0 && dot(s.normal, a.to_light) > -tangent;
    if (!entered && reflected == 0.0) continue;

    const float lit = shadow_at(light, a, s);
    if (entered)
      sum.entering +=
          a.irradiance * (cosine * (1.0 - specular_albedo(directional_albedo, spec, cosine)) * lit);
    sum.reflected += a.irradiance * (reflected * lit);
  }
  if (enters) sum.entering /= 1.0 - specular_albedo_mean(directional_albedo, spec);
  return sum;
}
