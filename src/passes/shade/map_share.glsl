// SPDX-License-Identifier: MIT
// The part of a term that its map can hold here. Needs SkinTermsIo and `io` (ShadeIo).
layout(constant_id = 14) const bool mixed = false;  // true: what it can't hold is lit at the pixel
#ifndef TERMS                                       // a pass may have it elsewhere
layout(binding = 31, scalar) uniform Terms { SkinTermsIo terms; };
#endif

// Returns the part of a term that is read from the map, 0..1. Texels spread light by half their side (box and
// bilinear tent: a variance of a quarter): a Gaussian of less than 0.35 texels is nearer to its own width
// without the map. The change is slow enough not to show. uv_per_mm: texture coordinates per mm, here.
float map_share(float sigma_mm, float uv_per_mm) {
  return mixed ? smoothstep(0.35, 0.7, sigma_mm * uv_per_mm * float(io.map_side)) : 1.0;
}
