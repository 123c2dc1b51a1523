// SPDX-License-Identifier: MIT
// As skin_lights.glsl, and transmitted light that arrives at the point: one read of each light's map for all.
// Follows skin_lights.glsl.
#include "render/shared/terms_io.h"
layout(binding = 23) uniform sampler2DArray entering_maps;
#ifndef TRANSMISSION  // a pass may have it elsewhere
layout(binding = 24, scalar) uniform Transmission { TransmissionIo transmission; };
#endif
layout(constant_id = 8) const int through_terms = 6;
#include "render/shaders/transmission.glsl"

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
