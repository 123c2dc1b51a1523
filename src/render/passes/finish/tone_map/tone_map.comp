// SPDX-License-Identifier: MIT
// Mixes the picture with its bloom and a colour behind the heads, and converts radiance to display values.
// The same curves as src/image/tone_map.cpp, which derives them; a test compares the two.
//
// Based on:
// - [PBRN] Khronos Group: Khronos PBR Neutral Tone Mapper, specification, 2024
// - [AgX] Sobotka: AgX, 2022; primaries of Blender 4.0, curve of Wrensch: Minimal AgX Implementation, 2023
// - [N15] Narkowicz: ACES Filmic Tone Mapping Curve, 2015
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "render/passes/finish/tone_map/tone_map_io.h"
layout(constant_id = 0) const uint tone_map = TONE_MAP_NATURAL;
layout(constant_id = 1) const bool blooms = false;
layout(constant_id = 3) const bool displays = true;  // else `light` alone is written
layout(constant_id = 2) const bool behind = false;   // a colour of the display stands behind the heads
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ToneMapIo io; };
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1, rgba8) uniform writeonly image2D display;
layout(binding = 2) uniform sampler2D open;
layout(binding = 3) uniform sampler2D narrow;
layout(binding = 4) uniform sampler2D wide;
layout(binding = 5, rgba16f) uniform writeonly image2D light;

const float max_half = 65504.0;

float greatest(vec3 c) { return max(max(c.r, c.g), c.b); }

// The root of 0 is 0; pow() alone may give NaN.
vec3 cube_root(vec3 c) { return mix(vec3(0.0), pow(c, vec3(1.0 / 3.0)), greaterThan(c, vec3(0.0))); }

// [PBRN] p_n, g.
float compressed_peak(float p, float begin) {
  return 1.0 - (1.0 - begin) * (1.0 - begin) / (p + 1.0 - 2.0 * begin);
}
float kept_chroma(float p, float p_n) { return 1.0 / (0.15 * (p - p_n) + 1.0); }

vec3 neutral(vec3 c) {
  const float f90 = 0.04;
  const float begin = 0.8 - f90;

  const float x = min(min(c.r, c.g), c.b);
  const float f = x <= 2.0 * f90 ? x - x * x / (4.0 * f90) : f90;
  c -= f;

  const float p = greatest(c);
  if (p <= begin) return c;
  const float p_n = compressed_peak(p, begin);
  return mix(vec3(p_n), c * (p_n / p), kept_chroma(p, p_n));
}

// [PBRN] without its toe, blending to white in cube roots.
vec3 natural(vec3 c) {
  const float begin = 0.8;
  const float p = greatest(c);
  if (p <= begin) return c;

  const float p_n = compressed_peak(p, begin);
  const vec3 root = mix(cube_root(vec3(p_n)), cube_root(c * (p_n / p)), kept_chroma(p, p_n));
  return root * root * root;
}

// ITU-R BT.2087. Columns.
const mat3 rec2020_of_rec709 = mat3(0.62740390, 0.06909729, 0.01639144, 0.32928304, 0.91954040, 0.08801331,
                                    0.04331307, 0.01136232, 0.89559525);
const mat3 rec709_of_rec2020 = mat3(1.66049100, -0.12455047, -0.01815076, -0.58764114, 1.13289990,
                                    -0.10057890, -0.07284986, -0.00834942, 1.11872966);
// [AgX]
const mat3 agx_inset = mat3(0.85662715, 0.13731897, 0.11189821, 0.09512124, 0.76124199, 0.07679942,
                            0.04825161, 0.10143904, 0.81130237);
const mat3 agx_outset = mat3(1.12710058, -0.14132976, -0.14132976, -0.11060664, 1.15782370, -0.11060664,
                             -0.01649394, -0.01649394, 1.25193641);

vec3 agx_curve(vec3 light) {
  const float least_ev = -12.47393, greatest_ev = 4.026069;
  const vec3 ev = clamp(log2(max(light, vec3(1e-10))), vec3(least_ev), vec3(greatest_ev));
  const vec3 x = (ev - least_ev) / (greatest_ev - least_ev);
  return -0.00232 + x * (0.1191 + x * (0.4298 + x * (-6.868 + x * (31.96 + x * (-40.14 + x * 15.5)))));
}

vec3 agx(vec3 c) {
  const vec3 shown = agx_outset * agx_curve(agx_inset * (rec2020_of_rec709 * c));
  const vec3 light = mix(vec3(0.0), pow(shown, vec3(2.2)), greaterThan(shown, vec3(0.0)));
  return clamp(rec709_of_rec2020 * light, vec3(0.0), vec3(1.0));
}

// [N15]
vec3 filmic(vec3 x) { return min(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), vec3(1.0)); }

vec3 tone_mapped(vec3 c) {
  if (tone_map == TONE_MAP_NATURAL) return natural(c);
  if (tone_map == TONE_MAP_NEUTRAL) return neutral(c);
  if (tone_map == TONE_MAP_AGX) return agx(c);
  if (tone_map == TONE_MAP_FILMIC) return filmic(c);
  return min(c, vec3(1.0));
}

// IEC 61966-2-1
vec3 srgb(vec3 x) {
  return mix(12.92 * x, 1.055 * pow(max(x, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055,
             greaterThan(x, vec3(0.0031308)));
}

// Returns the display value of radiance, before the curve of the display. NaN compares false and becomes
// black.
vec3 shown_light(vec3 radiance) {
  return tone_mapped(mix(vec3(0.0), min(radiance, vec3(max_half)), greaterThan(radiance, vec3(0.0))));
}

vec3 encoded(vec3 shown) { return tone_map == TONE_MAP_LINEAR ? shown : srgb(shown); }

// Halving may reach over the last pixel.
#define SPREAD_LIGHT(spread, halvings, p) \
  textureLod(spread, (vec2(p) + 0.5) / float(1u << halvings) / vec2(textureSize(spread, 0)), 0.0).rgb

void main() {
  const ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(p, imageSize(light)))) return;

  // Light that has spread is left out where a colour stands behind.
  const vec4 own = texelFetch(picture, p, 0);
  const float share = behind ? texelFetch(open, p, 0).r : 0.0;
  vec3 heads = own.rgb;
  if (blooms) {
    const vec3 spread = (1.0 - io.narrow - io.wide) * own.rgb +
                        io.narrow * SPREAD_LIGHT(narrow, io.narrow_halvings, p) +
                        io.wide * SPREAD_LIGHT(wide, io.wide_halvings, p);
    heads = mix(spread, own.rgb, share);
  }
  const vec3 sum = storable(heads + (behind ? share * io.linear : vec3(0.0)));
  imageStore(light, p, vec4(sum, own.a));

  if (!displays) return;
  // The heads by themselves go through the tone map; the colour is added to what is shown of them.
  vec3 shown = io.srgb;
  if (share < 1.0) {
    shown = shown_light(behind ? heads / (1.0 - share) : sum);
    if (behind) shown = mix(shown, tone_map == TONE_MAP_LINEAR ? io.srgb : io.linear, share);
    shown = encoded(shown);
  }
  imageStore(display, p, vec4(shown, 1.0));
}
