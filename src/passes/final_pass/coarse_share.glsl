// SPDX-License-Identifier: MIT
// The part of a term that is lit per pixel because the map has too few texels here: coarse_share() of
// final_pass.h. Needs SkinTermsIo.
layout(constant_id = 14) const bool coarse = false;  // true: some of the mesh may be coarse
#ifndef TERMS                                        // a pass may have it elsewhere
layout(binding = 31, scalar) uniform Terms { SkinTermsIo terms; };
#endif

float too_few(float x) { return 1.0 - smoothstep(0.075, 0.15, x); }

// uv_per_mm: texture coordinates per mm, there.
float coarse_share(float sigma_mm, float uv_per_mm) {
  if (!coarse) return 0.0;
  const float texels_per_mm = uv_per_mm * terms.largest_side;
  const float poor = max(too_few(uv_per_mm / terms.even_uv_per_mm), too_few(terms.widest_mm * texels_per_mm));
  return poor * (1.0 - smoothstep(0.2, 0.4, sigma_mm * texels_per_mm));
}
