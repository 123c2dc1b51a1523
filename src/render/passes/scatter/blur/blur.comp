// SPDX-License-Identifier: MIT
// One axis of one Gaussian. A Gaussian of variance v on the skin has covariance v g^-1 = v L L^T in texture
// coordinates, L = [a 0; b c]. The first pass runs along (a, b) in whole steps of u and interpolates in v;
// the second runs along v. The variance that interpolation adds is subtracted from the second pass. Right for
// any stretch and shear in two passes. Two Gaussians that start from the light share its reads in the first.
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "render/passes/scatter/blur/blur_io.h"
#include "render/shaders/tile_list.glsl"
layout(local_size_x = TILE_SIDE, local_size_y = TILE_SIDE) in;
layout(push_constant, scalar) uniform Push { BlurIo io; };
layout(binding = 0, rgba16f) uniform readonly image2D light_in;
layout(binding = 1) uniform sampler2D stretch;
layout(binding = 2) uniform utextureBuffer Kernels;
layout(binding = 3, rgba16f) uniform writeonly image2D light_out;
layout(binding = 4, scalar) readonly buffer Tiles { uint tiles[]; };
layout(binding = 5, scalar) readonly buffer TileCounts { uint tile_counts[]; };
layout(binding = 6, rgba16f) uniform writeonly image2D narrower_out;
layout(constant_id = 0) const bool two_terms = false;  // of the first axis: it also writes narrower_out

#include "render/passes/scatter/kernel_row.glsl"

// The light is a storage image, and coordinates are held inside in place of a branch. Reading it through a
// sampler, whose level may differ per invocation, takes twice as long on the software driver
// (docs/notes/performance.md).

// p: texel of the square. Outside its used part there is nothing: that is left over from another T.
ivec2 held_inside(ivec2 p) { return clamp(p, ivec2(0), ivec2(io.side) - 1) + ivec2(io.origin); }
vec4 none_outside(ivec2 p, vec4 texel) { return held_inside(p) == p + ivec2(io.origin) ? texel : vec4(0.0); }

vec4 light_at(ivec2 p) { return none_outside(p, imageLoad(light_in, held_inside(p))); }

// A Gaussian along an axis.
struct Taps {
  int step, reach;  // texels between taps; taps on either side
};

// Loads kernel_row. sigma: texels. Light that no blur has spread yet has edges between any two texels.
Taps load_kernel(float sigma) {
  const float most = io.texel_averaged != 0u ? KERNEL_MAX_SIGMA : SPACED_MAX_SIGMA;
  const int step = max(1, int(ceil(sigma / most)));
  const float spaced = min(sigma / float(step), KERNEL_MAX_SIGMA);
  const int reach = clamp(int(ceil(3.0 * spaced)), 1, KERNEL_RADIUS);
  const bool averaged = io.texel_averaged != 0u && step == 1;
  load_kernel_row(spaced / KERNEL_MAX_SIGMA * float(KERNEL_ROWS - 1), averaged ? KERNEL_ROWS : 0, reach);
  return Taps(step, reach);
}

float narrower_row[KERNEL_FLOATS];

// Loads narrower_row, 0 beyond its reach.
Taps load_narrower(float sigma) {
  const Taps taps = load_kernel(sigma);
  for (int k = 0; k < KERNEL_FLOATS; ++k) narrower_row[k] = k <= taps.reach ? kernel_row[k] : 0.0;
  return taps;
}

vec2 weights_at(int tap) { return vec2(kernel_row[tap], two_terms ? narrower_row[tap] : 0.0); }

struct Sums {
  vec3 light, narrower;
  float weight, narrower_weight;
};

void add(inout Sums s, vec4 texel, float chart, vec2 weights) {
  const vec2 used = texel.a == chart ? weights : vec2(0.0);
  s.light += used.x * texel.rgb;
  s.weight += used.x;
  if (!two_terms) return;
  s.narrower += used.y * texel.rgb;
  s.narrower_weight += used.y;
}

// Adds the taps along (a, b) beside the middle. slope: texels of v per texel of u. wanted: of both terms.
void add_along_u(inout Sums s, ivec2 p, float chart, Taps taps, float slope, vec2 wanted) {
  slope *= float(taps.step);
  for (int k = 1; k <= taps.reach; ++k) {
    const float shift = slope * float(k);
    const float whole = floor(shift);
    const float f = shift - whole;
    const ivec2 d = ivec2(k * taps.step, int(whole));
    const vec2 weights = wanted * weights_at(k);

    // The tap on the other side is at -shift: its two texels mirror these.
    add(s, light_at(p + d), chart, weights * (1.0 - f));
    add(s, light_at(p + d + ivec2(0, 1)), chart, weights * f);
    add(s, light_at(p - d), chart, weights * (1.0 - f));
    add(s, light_at(p - d - ivec2(0, 1)), chart, weights * f);
  }
}

// Writes the blurred light of a lit texel (centre.a != 0). The metric does not depend on T, nor
// does the size of its map.
void spread(ivec2 p, vec4 centre) {
  const float chart = centre.a;
  const ivec2 stretch_texel = ivec2((vec2(p) + 0.5) * (float(textureSize(stretch, 0).x) / float(io.side)));
  const vec3 factor = texelFetch(stretch, stretch_texel, 0).xyz * 0.001;  // per mm
  const float texels = float(io.side);
  const float sigma_mm = sqrt(io.variance_mm2);
  const float slope = factor.x > 0.0 ? factor.y / factor.x : 0.0;
  const ivec2 at = p + ivec2(io.origin);

  Taps narrower = Taps(1, 0);
  if (two_terms) narrower = load_narrower(sqrt(io.narrower_mm2) * factor.x * texels);
  const Taps along_u = load_kernel(sigma_mm * factor.x * texels);

  Sums s = Sums(vec3(0.0), vec3(0.0), 0.0, 0.0);
  if (io.axis == 0u) {
    const bool together = narrower.step == along_u.step;
    add(s, centre, chart, weights_at(0));
    add_along_u(s, p, chart, along_u, slope, vec2(1.0, together ? 1.0 : 0.0));
    if (two_terms) {
      add_along_u(s, p, chart, Taps(narrower.step, together ? 0 : narrower.reach), slope, vec2(0.0, 1.0));
      imageStore(narrower_out, at, vec4(storable(s.narrower / s.narrower_weight), chart));
    }
  } else {
    float interpolation = 0.0;  // variance in texels^2 that the first pass has added along v
    for (int k = 1; k <= along_u.reach; ++k) {
      const float f = fract(slope * float(along_u.step) * float(k));
      interpolation += 2.0 * kernel_row[k] * f * (1.0 - f);
    }

    const float wanted = sigma_mm * factor.z * texels;
    const Taps along_v = load_kernel(sqrt(max(wanted * wanted - interpolation, 0.0)));

    add(s, centre, chart, weights_at(0));
    for (int k = 1; k <= along_v.reach; ++k) {
      const ivec2 d = ivec2(0, k * along_v.step);
      add(s, light_at(p + d), chart, weights_at(k));
      add(s, light_at(p - d), chart, weights_at(k));
    }
  }
  imageStore(light_out, at, vec4(storable(s.light / s.weight), chart));
}

void main() {
  const uint i = tile_number(gl_WorkGroupID.xy);
  if (i >= tile_counts[io.list]) return;
  const ivec2 p = tile_corner(tiles[io.list * io.room + i]) + ivec2(gl_LocalInvocationID.xy);
  if (any(greaterThanEqual(p, ivec2(io.side)))) return;

  const vec4 own = imageLoad(light_in, p + ivec2(io.origin));
  if (own.a != 0.0) spread(p, own);
}
