// SPDX-License-Identifier: MIT
// As skin_radiance.glsl with no terms, in parts: techniques in screen space blur what enters before it
// leaves. THROUGH: with transmitted light. Based on: [JWS10] Jimenez, Whelan, Sundstedt, Gutierrez: Real-Time
// Realistic Skin Translucency. CG&A 30(4), 2010
#include "shaders/skin_answer.glsl"
#include "passes/shade/along_skin.glsl"
#ifdef THROUGH
#include "passes/shade/through_at_pixel.glsl"
#endif

struct SplitSkin {
  vec3 light;    // what is blurred: entered, times the part of the albedo before scattering; radiance
  vec3 leaving;  // what blurred light is multiplied by
  vec3 rest;     // what is not blurred: light lit at the pixel, reflection, emission
};

SplitSkin mean_of(SplitSkin a, SplitSkin b) {
  return SplitSkin(0.5 * (a.light + b.light), 0.5 * (a.leaving + b.leaving), 0.5 * (a.rest + b.rest));
}

// blurred: the share of the light. Where skin occludes a lobe of its reflection, it reflects light that has
// not been blurred. The parts can be stored in half floats.
SplitSkin skin_split(ShadingPoint s, vec2 unwrap, vec3 blurred) {
  const vec3 v = view_vector(s.position_m);
  const vec3 n = skin_normal(s);
  const SkinSpecular spec = skin_specular(s);
  const SkinView view = skin_view(n, v, spec);
  const vec3 albedo = skin_albedo(s);

#ifdef THROUGH
  const LitThrough r = lit_through(s, n, spec, view);
  const LitSkin lit = r.skin;
#else
  const LitSkin lit = lit_skin(s, n, spec, true, view);
#endif
  const vec3 entering = (lit.entering + entering_surroundings(s, n, unwrap)) * (frame.radiance_scale / pi);
  const vec3 surroundings =
      mirrored_surroundings(s, unwrap, view, spec, entering * albedo / frame.radiance_scale);
  const float leaves = 1.0 - specular_albedo(directional_albedo, spec, dot(view.n, v));

  SplitSkin split;
  split.light = entering * albedo_power(albedo, material.mix_before);
#ifdef THROUGH
  // It is blurred as well, as [JWS10] has it; the weights of its terms are shares of all light.
  split.light += all_through(r) * (frame.radiance_scale / pi) / max(blurred, vec3(1e-6));
#endif
  split.light = storable(split.light);
  split.leaving = blurred * albedo_power(albedo, 1.0 - material.mix_before) * leaves;
  split.rest =
      (1.0 - blurred) * entering * albedo * leaves + (lit.reflected + surroundings) * frame.radiance_scale;
  if (emits) split.rest += emitted(s) * frame.radiance_scale;
  split.rest = storable(split.rest);
  return split;
}
