// SPDX-License-Identifier: MIT
// Light from skin at a point beside scattered light: emission, and reflection of
// the surroundings.
#include "render/shaders/half.glsl"
#include "render/shaders/skin_point.glsl"
#include "render/shaders/cut_out.glsl"
layout(constant_id = 12) const bool emits = false;
layout(binding = 13) uniform sampler2D map_emissive;
layout(constant_id = 22) const bool detailed = false;
layout(binding = 30) uniform sampler2D map_detail;

vec3 skin_normal(ShadingPoint s) {
  const MapIo map = material.maps[MAP_NORMAL];
  return detailed ? detailed_normal(map, map_normal, material.maps[MAP_DETAIL], map_detail, s)
                  : mapped_normal(map, map_normal, s);
}

vec3 emitted(ShadingPoint s) {
  const MapIo map = material.maps[MAP_EMISSIVE];
  return is_present(map) ? material.emissive * map_texel(map_emissive, map, s).rgb : material.emissive;
}

// Returns the environment in both lobes, by their directional albedo. Where skin occludes it, the lobe
// reflects `skin`, the radiance that leaves skin here. At grazing angles a lobe is narrower than its slope
// and bent towards the normal. Both fits are ours, within 4 degrees and a quarter of the width of the lobe's
// mean, m = 0.1 to 0.4.
vec3 mirrored_surroundings(ShadingPoint s, vec2 unwrap, SkinView view, SkinSpecular spec, vec3 skin) {
  const vec3 n = view.n, v = view.to_eye;
  const float n_v = dot(n, v), all = specular_albedo(directional_albedo, spec, n_v),
              open = skin_open(s, unwrap);
  if (!environment) return frame.ambient * (all * open);

  const vec3 mirrored = reflect(-v, n),
             turned = off_map ? vec3(0.0) : world_direction(textureLod(bent_normal, unwrap, 0.0).xyz),
             sky = normalize(s.normal + turned);
  const float above = clamp(1.0 + 1.3 * dot(mirrored, s.normal), 0.0,
                            1.0);  // a mapped normal may reflect directions below the surface

  vec2 albedo = vec2(0.0);
  vec3 lobe[2];
  for (int k = 0; k < 2; ++k) {
    albedo[k] = spec.weight[k] * directional_albedo_lookup(directional_albedo, n_v, spec.m[k], spec.f0);
    const float slope = spec.m[k] * sqrt(max(n_v, lobe_least_cosine));
    const vec3 towards = normalize(mirrored + n * (lobe_bend * spec.m[k] * pow(1.0 - n_v, 4.0)));
    lobe[k] = mix(skin, surroundings_radiance(towards, slope),
                  sky_in_lobe(sky, open, towards, slope) * above * above);
  }

  return (lobe[0] * albedo.x + lobe[1] * albedo.y) * (all / max(albedo.x + albedo.y, 1e-6));
}
