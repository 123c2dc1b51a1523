// SPDX-License-Identifier: MIT
// The part of the albedo that acts before scattering, and as alpha the chart of the texel. Needs
// skin_point.glsl and cut_chart.glsl.

// Pixels of skin beside it read what is cut away; convolutions skip it.
vec4 albedo_before(ShadingPoint s, float chart, CutTexel cut) {
  const bool cut_away = cut_out && is_cut(cut.uv, cut.colour);
  const vec3 albedo = cut_away ? albedo_beside(cut) : skin_albedo(s);
  return vec4(albedo_power(albedo, material.mix_before), cut_away ? BORDER_ALPHA : chart);
}
