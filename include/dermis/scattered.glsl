// SPDX-License-Identifier: MIT
// The light that has spread in the skin of a head, for a host that shades the head itself: way (iii) of
// dermis/vulkan.h. Before the include, say where the host binds what HostFrames::record() returns:
//
//   #define DERMIS_SET 1
//   #define DERMIS_LIGHT_BINDING 0    // Recorded::scattered, with any sampler
//   #define DERMIS_RECORDS_BINDING 1  // Recorded::records, a storage buffer
//   #include "dermis/scattered.glsl"
//   ...
//   const DermisScattered skin = dermis_scattered(record, uv);
//   vec3 diffuse = skin.light * pow(albedo, vec3(1.0 - mix_before)) + skin.rest * lit * albedo;
//
// lit: irradiance at the pixel, times 2^exposure_ev / pi: of lamps with their shadows, and of surroundings.
// Light that is reflected does not enter: see below. Light through the body comes with the terms on maps
// alone, so far ears lose their glow; quality.depth false keeps it.
// record: HostFrames::record_of(); uv: TEXCOORD_0 of the asset as it is, interpolated `centroid` where there
// are several samples per pixel. The host adds reflections, and takes from the diffuse light what these keep:
// 1 minus the directional albedo of the specular. dermis's own: 0.18 pi times Beckmann's lobe with Schlick's
// Fresnel and Smith's masking, correlated by height (Walter et al., EGSR 2007; Heitz, JCGT 3(2), 2014).
// mix_before: that of the material, dermis's default is 0.5.
#ifndef DERMIS_SCATTERED_GLSL
#define DERMIS_SCATTERED_GLSL
#extension GL_EXT_scalar_block_layout : require

struct DermisRecord {
  vec2 uv_scale, uv_offset;  // from the asset's texture coordinates to its map, which is 0..1
  vec2 origin;               // of the head's square in the layer, texels
  float side;                // of the square, texels
  uint layer;                // of the light; the weight of the rest is in the next
  uint lit;                  // 0: nothing is read from maps; outside the picture, hidden, or far away
  float unlit_rest;          // the rest where nothing is read: 0 if the light is HostInputs::draw_irradiance
};

layout(set = DERMIS_SET, binding = DERMIS_LIGHT_BINDING) uniform sampler2DArray dermis_light;
layout(set = DERMIS_SET, binding = DERMIS_RECORDS_BINDING, scalar) readonly buffer DermisRecords {
  DermisRecord dermis_records[];
};

// Returns the position of texture coordinates in the map of a head, 0..1: where a host draws irradiance.
vec2 dermis_map_position(uint record, vec2 uv) {
  const DermisRecord r = dermis_records[record];
  return uv * r.uv_scale + r.uv_offset;
}

// The light of the terms of the profile that light maps hold, and the weight of the others. These are narrow:
// save in close-ups, pixels cannot tell them from light that leaves where it entered.
struct DermisScattered {
  // Radiance that leaves white skin, times 2^exposure_ev: linear Rec.709, with the part of the albedo that
  // acts before the light spreads.
  vec3 light;
  vec3 rest;  // per channel; unlit_rest where the head is not lit, or so far away that no term is mapped
};

// Returns those at texture coordinates of a head. Bilinear among the texels that hold skin; a texel beside an
// open border counts only if there is nothing else.
DermisScattered dermis_scattered(uint record, vec2 uv) {
  const DermisRecord r = dermis_records[record];
  const DermisScattered none = DermisScattered(vec3(0.0), vec3(r.unlit_rest));
  if (r.lit == 0u) return none;

  const float margin = 0.5 + 1.0 / 256.0;
  const vec2 p = clamp((uv * r.uv_scale + r.uv_offset) * r.side, margin, r.side - margin) - 0.5;
  const vec2 corner = floor(p), f = p - corner;
  DermisScattered sum = DermisScattered(vec3(0.0), vec3(0.0));
  float total = 0.0;
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const ivec2 at = clamp(ivec2(corner) + d, ivec2(0), ivec2(r.side) - 1) + ivec2(r.origin);
    const vec4 texel = texelFetch(dermis_light, ivec3(at, int(r.layer)), 0);
    const float bilinear = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y);
    // A texel without weight may lie outside the square and hold anything: 0 times NaN is NaN.
    if (bilinear <= 0.0 || texel.a == 0.0) continue;

    const float weight = bilinear * (texel.a > 1.0 ? 1.0 / 256.0 : 1.0);
    sum.light += weight * texel.rgb;
    sum.rest += weight * texelFetch(dermis_light, ivec3(at, int(r.layer) + 1), 0).rgb;
    total += weight;
  }
  if (total == 0.0) return none;
  return DermisScattered(sum.light / total, sum.rest / total);
}
#endif
