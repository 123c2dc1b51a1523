// SPDX-License-Identifier: MIT
// The final pass, [DLE07] sec. 3.4 and GPU Gems 3, ch. 14.4.6: the weighted sum of the irradiance maps, the
// rest of the albedo, and specular.
#version 460
#include "render/techniques/published/final_io.h"
#include "render/shared/scene_io.h"
layout(push_constant, scalar) uniform Push { PaperFinalIo io; };
layout(location = 0) in vec3 in_position_m;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 8) in float in_plane_m;  // plane_distance()
layout(location = 0) out vec4 out_radiance;
#include "render/techniques/published/lobe.glsl"
#include "render/shaders/skin_answer.glsl"
layout(constant_id = 0) const int term_count = 6;
// The rest of the weights to 1 is lit at the pixel. Departure, for what no map holds: light that leaves where
// it entered (a term without width), and skin that has no place on the map, which does not scatter then.
layout(constant_id = 1) const bool direct = false;
layout(binding = 14) uniform sampler2D light_0;
layout(binding = 15) uniform sampler2D light_1;
layout(binding = 16) uniform sampler2D light_2;
layout(binding = 17) uniform sampler2D light_3;
layout(binding = 18) uniform sampler2D light_4;
layout(binding = 19) uniform sampler2D light_5;
layout(binding = 20) uniform sampler2D light_6;
layout(binding = 21) uniform sampler2D light_7;
#include "render/shaders/map_read.glsl"
#include "render/techniques/published/map_point.glsl"

// Departure: of the four texels those that hold light are read. Beside what is culled or clipped [JG08] reads
// texels that were cleared, too, and the skin there is dark: 0.71 of a white furnace.
vec3 light_of(sampler2D light, vec2 at, bool whole) {
  return whole ? textureLod(light, at, 0.0).rgb : light_left(light, at);
}

// [JG08] eq. 2, [DLE07] sec. 3.4: R = sum_i w_i G(v_i), of light that has been convolved by each. Already
// times 2^EV / pi.
vec3 scattered() {
  const vec2 at = map_point() / vec2(textureSize(light_0, 0));
  const bool whole = !cut_out && all(notEqual(textureGather(light_0, at, 3), vec4(0.0)));
  vec3 sum = vec3(0.0);
  if (term_count > 0) sum += io.weights[0] * light_of(light_0, at, whole);
  if (term_count > 1) sum += io.weights[1] * light_of(light_1, at, whole);
  if (term_count > 2) sum += io.weights[2] * light_of(light_2, at, whole);
  if (term_count > 3) sum += io.weights[3] * light_of(light_3, at, whole);
  if (term_count > 4) sum += io.weights[4] * light_of(light_4, at, whole);
  if (term_count > 5) sum += io.weights[5] * light_of(light_5, at, whole);
  if (term_count > 6) sum += io.weights[6] * light_of(light_6, at, whole);
  if (term_count > 7) sum += io.weights[7] * light_of(light_7, at, whole);
  return sum;
}

// s.normal: interpolated, turned to the side that is seen. The result can be stored in half floats.
vec3 skin_radiance(ShadingPoint s) {
  const vec3 v = view_vector(s.position_m);
  const vec3 n = skin_normal(s);
  const SkinSpecular spec = skin_specular(s);
  const SkinView view = skin_view(n, v, spec);
  const vec3 albedo = skin_albedo(s);
  const LitSkin lit = lit_skin(s, n, spec, direct, view);

  // [DLE07] sec. 3.4: the part of the albedo that acts after scattering.
  vec3 diffuse = vec3(0.0);
  if (term_count > 0) diffuse = scattered() * albedo_power(albedo, 1.0 - material.mix_before);
  if (direct) {
    vec3 share = vec3(1.0);
    for (int i = 0; i < term_count; ++i) share -= io.weights[i];
    const vec3 entering = lit.entering + entering_surroundings(s, n, within_triangle(in_unwrap));
    diffuse += share * entering * albedo * (frame.radiance_scale / pi);
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
