// SPDX-License-Identifier: MIT
// Skin under the lights of a frame: light enters, and light is reflected to the
// eye. Each light's shadow, which costs more than the rest, is evaluated once for both. Follows
// skin_point.glsl.

// The view of a point.
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

// Sums over the lights. enters: whether the light that enters is wanted. It is without what the surface
// reflects. The division by its mean over all directions here, where light enters, keeps a white furnace
// white, also with maps that vary: (1-rho(L)) (1-rho(V)) / (1-rho_mean).
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
