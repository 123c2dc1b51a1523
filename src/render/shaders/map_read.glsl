// SPDX-License-Identifier: MIT
// Reads of light maps.
#include "render/shared/gutters_io.h"

// Returns the part of a term that is read from a light map, 0..1; the rest is lit at the pixel. Texels spread
// light by half their side (box and bilinear tent: a variance of a quarter). So a Gaussian of less than 0.35
// texels is nearer to its own width without the map, unless the pixel averages as much. The change is slow
// enough not to show. Light before any blur (sigma_mm 0) counts a little earlier; earlier yet, rims that are
// lit from behind are too bright.
//
// shown_mm: by how much a pixel averages light, as a sigma. uv_per_mm: texture coordinates per mm, here.
// side: of the map, texels.
float map_share(float sigma_mm, float shown_mm, float uv_per_mm, uint side) {
  const float texels = max(sigma_mm, shown_mm) * uv_per_mm * float(side);
  return sigma_mm > 0.0 ? smoothstep(0.35, 0.7, texels) : smoothstep(0.28, 0.56, texels);
}

// Returns the light at a texture coordinate, bilinear among the texels that hold skin. Beside a cut the light
// map continues for a texel that convolutions skip; it is used only if there is nothing else.
vec3 light_left(sampler2D light, vec2 at) {
  const ivec2 size = textureSize(light, 0);
  const vec2 p = at * vec2(size) - 0.5, corner = floor(p), f = p - corner;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const vec4 texel = texelFetch(light, clamp(ivec2(corner) + d, ivec2(0), size - 1), 0);
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y);
    // A texel without weight may be outside the used square and hold anything: 0 times NaN is NaN.
    if (weight <= 0.0 || texel.a == 0.0) continue;
    sum += weight * (texel.a == BORDER_ALPHA ? 1.0 / 256.0 : 1.0) * vec4(texel.rgb, 1.0);
  }
  return sum.rgb / max(sum.w, 1e-6);
}
