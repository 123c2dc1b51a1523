// SPDX-License-Identifier: MIT
// Shades the entries of a part as skin_radiance.glsl with no terms, but in
// parts: techniques in screen space blur what enters before it leaves. Light to be blurred goes to images,
// the rest to the entries. THROUGH: with transmitted light. Based on: [JWS10] Jimenez, Whelan, Sundstedt,
// Gutierrez: Real-Time Realistic Skin Translucency. CG&A 30(4), 2010
// Variant shade_split_through.comp: THROUGH
#version 460
#include "render/passes/pixels/shade/listed_entry.glsl"
#include "render/passes/screen/screen_surface.glsl"
#include "render/shaders/skin_answer.glsl"
#ifdef THROUGH
#include "render/shaders/transmission.glsl"
#endif

struct SplitSkin {
  vec3 light;    // to be blurred: entered, times the part of the albedo before scattering; radiance
  vec3 leaving;  // factor of the blurred light
  vec3 rest;     // not blurred: light lit at the pixel, reflection, emission
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

const bool mixed = false;
#include "render/passes/pixels/shade/shade_point.glsl"
layout(binding = 14, rgba16f) uniform writeonly image2D light_of_skin;
layout(binding = 15, r32f) uniform writeonly image2D depth_of_skin;
layout(binding = 16, r32ui) uniform writeonly uimage2D surface_of_skin;
layout(binding = 17, rgba16f) uniform writeonly image2DArray leaving_skin;
layout(binding = 18, scalar) uniform Split { SplitIo split; };
layout(binding = 19, r32ui) uniform readonly uimage2D samples_of_pixels;

void main() {
  Entry entry;
  if (!find_entry(entry)) return;
  const SeenSkin seen = seen_skin(entry, 0);
  SplitSkin skin = skin_split(seen.s, seen.on.unwrap, split.blurred);
  vec3 middle_m = seen.s.position_m;
  if (light_samples == 2) {
    const SeenSkin second = seen_skin(entry, 1);
    skin = mean_of(skin, skin_split(second.s, second.on.unwrap, split.blurred));
    middle_m = 0.5 * (middle_m + second.s.position_m);
  }

  const ivec2 at = entry.at.xy;
  if (entry.at.z == 0) {
    const float depth_m = dot(middle_m - frame.camera.eye_m, frame.camera.direction);
    imageStore(light_of_skin, at, vec4(skin.light, 1.0));
    imageStore(depth_of_skin, at, vec4(depth_m * split.mm_per_unit));
    imageStore(surface_of_skin, at, uvec4(packed_surface(split.head, seen.s.normal)));
  } else {
    // The light of another head is not this head's: there is none of its own in this pixel.
    const uint part = imageLoad(samples_of_pixels, at).x >> SAMPLES_BITS;
    if (part < split.first_part || part >= split.end_part) {
      skin.rest = storable(skin.rest + skin.leaving * skin.light);
      skin.leaving = vec3(0.0);
    }
  }
  imageStore(leaving_skin, entry.at, vec4(round_to_half(skin.leaving), split.mesh));
  imageStore(entries_of_pixels, entry.at, entry_of(skin.rest));
}
