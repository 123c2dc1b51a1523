// SPDX-License-Identifier: MIT
// The final pass, [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6: the weighted sum of the irradiance maps, the
// rest of the albedo, and specular. THROUGH: light through the body where terms are lit per pixel.
#include "techniques/published/final_io.h"
#include "shared/scene_io.h"
layout(push_constant, scalar) uniform Push { PaperFinalIo io; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 8) in float in_plane_m;  // plane_distance()
layout(location = 0) out vec4 out_radiance;
#include "techniques/published/lobe.glsl"
#include "shaders/skin_answer.glsl"
#include "shared/gutters_io.h"
#ifdef THROUGH
#include "shaders/skin_through.glsl"
#endif
layout(constant_id = 0) const int term_count = 6;
layout(constant_id = 1) const bool direct = false;  // what the weights lack of 1 is lit per pixel
layout(binding = 14) uniform sampler2D light_0;
layout(binding = 15) uniform sampler2D light_1;
layout(binding = 16) uniform sampler2D light_2;
layout(binding = 17) uniform sampler2D light_3;
layout(binding = 18) uniform sampler2D light_4;
layout(binding = 19) uniform sampler2D light_5;
layout(binding = 20) uniform sampler2D light_6;
layout(binding = 21) uniform sampler2D light_7;
#include "shaders/light_left.glsl"
#include "techniques/published/map_point.glsl"

// Returns whether a term is read from its map. One without weight may not have been written: 0 times NaN is
// NaN.
bool is_read(int i) { return i < term_count && (!direct || io.weights[i] != vec3(float(nothing()))); }

vec3 light_of(sampler2D light, vec2 at) {
  return cut_out ? light_left(light, at) : textureLod(light, at, 0.0).rgb;
}

// [JG08] eq. 2, [DLE07] sec. 3.4: R = sum_i w_i G(v_i), of light that has been convolved by each. Already
// times 2^EV / pi.
vec3 scattered() {
  const vec2 at = map_point() / vec2(textureSize(light_0, 0));
  vec3 sum = vec3(0.0);
  if (is_read(0)) sum += io.weights[0] * light_of(light_0, at);
  if (is_read(1)) sum += io.weights[1] * light_of(light_1, at);
  if (is_read(2)) sum += io.weights[2] * light_of(light_2, at);
  if (is_read(3)) sum += io.weights[3] * light_of(light_3, at);
  if (is_read(4)) sum += io.weights[4] * light_of(light_4, at);
  if (is_read(5)) sum += io.weights[5] * light_of(light_5, at);
  if (is_read(6)) sum += io.weights[6] * light_of(light_6, at);
  if (is_read(7)) sum += io.weights[7] * light_of(light_7, at);
  return sum;
}

#ifdef THROUGH
// Returns the transmitted light that the maps would show, for the part of the terms lit here: terms of a
// group share their mean.
vec3 through_share(LitThrough r) {
  vec3 sum = vec3(0.0), mean = vec3(0.0);
  for (int g = 0; g < TRANSMISSION_GROUPS; ++g) {
    mean += joining(r, g);
    vec3 share = transmission.group_weight[g];
    for (int i = 0; i < term_count; ++i)
      if (transmission.group[i] == uint(g)) share -= io.weights[i];
    sum += share * mean;
  }
  return sum;
}
#endif

// s.normal: interpolated, turned to the side that is seen. The result can be stored in half floats.
vec3 skin_radiance(ShadingPoint s) {
  const vec3 v = view_vector(s.position_m);
  const vec3 n = skin_normal(s);
  const SkinSpecular spec = skin_specular(s);
  const SkinView view = skin_view(n, v, spec);
  const vec3 albedo = skin_albedo(s);
#ifdef THROUGH
  const LitThrough r = lit_through(s, n, spec, view);
  const LitSkin lit = r.skin;
#else
  const LitSkin lit = lit_skin(s, n, spec, direct, view);
#endif

  // [DLE07] sec. 3.4: the part of the albedo that acts after scattering.
  vec3 diffuse = vec3(0.0);
  if (term_count > 0) diffuse = scattered() * albedo_power(albedo, 1.0 - material.mix_before);
  if (direct) {
    vec3 share = vec3(1.0);
    for (int i = 0; i < term_count; ++i) share -= io.weights[i];
    const vec3 entering = lit.entering + entering_surroundings(s, n, within_triangle(in_unwrap));
    vec3 leaving = share * entering * albedo;
#ifdef THROUGH
    leaving += through_share(r) * albedo_power(albedo, 1.0 - material.mix_before);
#endif
    diffuse += leaving * (frame.radiance_scale / pi);
  }

  // Kelemen and Szirmay-Kalos, GPU Gems 3, ch. 14.3, and what it reflects does not leave: ch. 14.4.6.
  const vec3 surroundings =
      mirrored_surroundings(s, within_triangle(in_unwrap), view, spec, diffuse / frame.radiance_scale);
  diffuse *= 1.0 - specular_albedo(directional_albedo, spec, dot(view.n, v));
  vec3 radiance = diffuse + (lit.reflected + surroundings) * frame.radiance_scale;
  if (emits) radiance += emitted(s) * frame.radiance_scale;
  return storable(radiance);
}

void main() {
  const ShadingPoint s = drawn_point(in_position_m, in_normal, in_plane_m, in_tangent, in_uv, in_colour,
                                     gl_FrontFacing ? 1.0 : -1.0);
  const vec3 radiance = skin_radiance(s);
  if (cut_out && is_cut(in_uv, in_colour)) discard;
  out_radiance = vec4(radiance, 1.0);  // alpha marks skin
}
