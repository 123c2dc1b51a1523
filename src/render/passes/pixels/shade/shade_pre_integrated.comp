// SPDX-License-Identifier: MIT
// Shades the entries of a part as skin_radiance.glsl with no terms, but by
// tables in place of a blur. Light that enters has scattered over a ball as bent as the skin here, and over
// the edges of shadows. THROUGH: with transmitted light. Based on: [Pen11] and [FW14] of
// tissue/gaussians/pre_integrated.h.
// Variant shade_pre_integrated_through.comp: THROUGH
#version 460
#include "render/passes/pixels/shade/listed_entry.glsl"
#include "render/passes/pixels/shade/pre_integrated_io.h"
layout(binding = 19, scalar) readonly buffer Curvature { float curvature[]; };
#include "render/shaders/skin_answer.glsl"
#include "render/passes/pixels/shade/wide_shadow.glsl"
#ifdef THROUGH
#include "render/shaders/transmission.glsl"
#endif
layout(constant_id = 21) const bool unscattered = false;  // some light leaves where it entered
layout(binding = 16) uniform sampler2D lit_table;
layout(binding = 17) uniform sampler2D edge_table;
layout(binding = 18, scalar) uniform PreIntegrated { PreIntegratedIo scatter; };

// Arguments of the tables, beside lights.
struct Bent {
  vec3 sharp, blurred;  // mapped normals; light of red scatters furthest
  float curvature_per_mm;
};

// Returns the mapped normal of a level of the map in which texels are as far apart as light scatters.
vec3 blurred_normal(ShadingPoint s, float uv_per_mm) {
  const MapIo map = material.maps[MAP_NORMAL];
  if (!is_present(map)) return s.normal;
  const vec2 size = vec2(textureSize(map_normal, 0));
  const float texels = scatter.normal_mm * uv_per_mm * sqrt(size.x * size.y);
  vec3 t = textureLod(map_normal, map_uv(map, s), log2(max(texels, 1.0))).xyz * 2.0 - 1.0;
  t.xy *= map.scale;
  const vec3 bitangent = cross(s.normal, s.tangent.xyz) * s.tangent.w;
  const vec3 n = s.tangent.xyz * t.x + bitangent * t.y + s.normal * t.z;
  const float length2 = dot(n, n);
  return length2 > 1e-12 ? n * inversesqrt(length2) : s.normal;
}

// Returns the share of a light that red, green and blue show, unshadowed. [FW14]: the less blurred normals
// count where the light is faced.
vec3 lit_share(Bent bent, vec3 to_light, float tangent) {
  const float cosine = dot(bent.blurred, to_light), facing = clamp(1.0 - cosine, 0.0, 1.0),
              q = facing * facing;
  const vec2 size = vec2(textureSize(lit_table, 0));
  const float row = sqrt(clamp(bent.curvature_per_mm / scatter.most_curvature_per_mm, 0.0, 1.0));
  const vec2 at = (vec2(0.5 + 0.5 * cosine, row) * (size - 1.0) + 0.5) / size;
  const vec3 more = textureLod(lit_table, at, 0.0).rgb;
  const float sharp = dot(bent.sharp, to_light);
  const vec3 cosines = vec3(cosine, mix(sharp, cosine, min(0.3 + 0.7 * q, 1.0)), mix(sharp, cosine, q));
  return clamp(more + vec3(light_cosine(cosines.r, tangent), light_cosine(cosines.g, tangent),
                           light_cosine(cosines.b, tangent)),
               0.0, 1.0);
}

// Returns the share of a light that is left beside the edge of a shadow. Penumbrae of discs are not
// scattered.
vec3 shadow_share(LightIo light, Arriving a, ShadingPoint s, Bent bent) {
  const float cosine = dot(s.normal, a.to_light);
  if (soft_shadows && light.radius > 0.0) return vec3(shadow_at(light, a, s));
  const float radius_m = 0.5 * scatter.filter_mm / scatter.mm_per_unit;
  // Behind the terminator the ball that the table stands for is in the way; that is in the table.
  const float ball_m = 2.0 / (max(bent.curvature_per_mm, 0.01) * scatter.mm_per_unit);
  const float inside_m =
      lit_distance_m(light, a, s, radius_m, min(max(-cosine, 0.0) * ball_m, 2.0 * radius_m));
  // On the surface shadows are longer than across the light.
  const float x = inside_m / (radius_m * clamp(cosine, 0.15, 1.0)),
              column = 0.5 + 0.5 * sign(x) * sqrt(min(abs(x), 1.0)),
              columns = float(textureSize(edge_table, 0).x);
  return textureLod(edge_table, vec2((column * (columns - 1.0) + 0.5) / columns, 0.5), 0.0).rgb;
}

// Returns the light that enters and what is reflected, as lit_skin().
LitSkin lit_bent_skin(ShadingPoint s, Bent bent, SkinSpecular spec, SkinView view) {
  LitSkin sum = LitSkin(vec3(0.0), vec3(0.0));
  for (uint i = nothing(); i < frame.light_count; ++i) {
    const LightIo light = light_at(i);
    const Arriving a = arriving_light(light, s.position_m);
    const float reflected = reflected_share(view, spec, light, a, s.normal);
    const vec3 share = lit_share(bent, a.to_light, light_tangent(light, a));
    const float enters = max(max(share.r, share.g), share.b);
    if (enters > 1e-5)
      sum.entering += a.irradiance * share * shadow_share(light, a, s, bent) *
                      (1.0 - specular_albedo(directional_albedo, spec, enters));
    if (reflected > 0.0) sum.reflected += a.irradiance * (reflected * shadow_at(light, a, s));
  }
  sum.entering /= 1.0 - specular_albedo_mean(directional_albedo, spec);
  return sum;
}

// Returns the irradiance that enters from the surroundings, by a normal for each channel.
vec3 bent_surroundings(ShadingPoint s, Bent bent, vec2 unwrap) {
  const vec3 green = normalize(mix(bent.sharp, bent.blurred, 0.3));
  return vec3(entering_surroundings(s, bent.blurred, unwrap).r, entering_surroundings(s, green, unwrap).g,
              entering_surroundings(s, bent.sharp, unwrap).b);
}

// The result can be stored in half floats.
vec3 skin_pre_integrated(ShadingPoint s, vec2 unwrap, float curvature_per_mm, float uv_per_mm) {
  const vec3 v = view_vector(s.position_m);
  const vec3 n = skin_normal(s);
  const SkinSpecular spec = skin_specular(s);
  const SkinView view = skin_view(n, v, spec);
  const vec3 albedo = skin_albedo(s);

  const Bent bent = Bent(n, blurred_normal(s, uv_per_mm), curvature_per_mm);
  const LitSkin lit = lit_bent_skin(s, bent, spec, view);
  vec3 entering = lit.entering + bent_surroundings(s, bent, unwrap);
  if (unscattered) {
    const LitSkin there = lit_skin(s, n, spec, true, skin_view(n, v, spec));
    entering = scatter.scattered * entering +
               (1.0 - scatter.scattered) * (there.entering + entering_surroundings(s, n, unwrap));
  }

  vec3 leaving = entering * albedo;
#ifdef THROUGH
  leaving += all_through(lit_through(s, n, spec, unseen)) * albedo_power(albedo, 1.0 - material.mix_before);
#endif
  vec3 diffuse = leaving * (frame.radiance_scale / pi);
  const vec3 surroundings = mirrored_surroundings(s, unwrap, view, spec, diffuse / frame.radiance_scale);
  diffuse *= 1.0 - specular_albedo(directional_albedo, spec, dot(view.n, v));
  vec3 radiance = diffuse + (lit.reflected + surroundings) * frame.radiance_scale;
  if (emits) radiance += emitted(s) * frame.radiance_scale;
  return storable(radiance);
}

const bool mixed = false;
#include "render/passes/pixels/shade/shade_point.glsl"

// Returns coordinates of the normal map per mm of the asset, of a triangle.
float normal_uv_per_mm(uvec3 corners) {
  const VertexIo a = vertex_at(corners.x), b = vertex_at(corners.y), c = vertex_at(corners.z);
  const MapIo map = material.maps[MAP_NORMAL];
  vec2 e = b.uv0 - a.uv0, f = c.uv0 - a.uv0;
  if (map.uv_set != 0u) {
    const vec2 first = vertex_extra(corners.x).uv1;
    e = vertex_extra(corners.y).uv1 - first;
    f = vertex_extra(corners.z).uv1 - first;
  }
  const float turned = map.u_axis.x * map.v_axis.y - map.u_axis.y * map.v_axis.x;
  const vec3 p = world_position(b.position_m) - world_position(a.position_m),
             q = world_position(c.position_m) - world_position(a.position_m);
  const float area_mm2 = length(cross(p, q)) * scatter.mm_per_unit * scatter.mm_per_unit;
  return sqrt(abs((e.x * f.y - e.y * f.x) * turned) / max(area_mm2, 1e-12));
}

vec3 seen_radiance(SeenSkin seen) {
  const float per_mm =
      dot(seen.share, vec3(curvature[seen.corners.x], curvature[seen.corners.y], curvature[seen.corners.z]));
  return skin_pre_integrated(seen.s, seen.on.unwrap, per_mm, normal_uv_per_mm(seen.corners));
}

void main() {
  Entry entry;
  if (!find_entry(entry)) return;
  vec3 radiance = seen_radiance(seen_skin(entry, 0));
  if (light_samples == 2) radiance = 0.5 * (radiance + seen_radiance(seen_skin(entry, 1)));
  imageStore(entries_of_pixels, entry.at, entry_of(radiance));
}
