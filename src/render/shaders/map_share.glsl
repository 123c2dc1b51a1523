// SPDX-License-Identifier: MIT
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
