// SPDX-License-Identifier: MIT
/// Directional albedo of the specular lobe, tabulated: rho(cos, m) = int f cos dw with rho_s factored out.
/// Based on:
/// [DLE07] GPU Gems 3, ch. 14.3.2
/// [KSK01] Kelemen, Szirmay-Kalos: A Microfacet Based Coupled Specular-Matte BRDF Model. Eurographics 2001
/// [WMLT07] Walter et al.: Microfacet Models for Refraction through Rough Surfaces. EGSR 2007
/// [Hei14] Heitz: Understanding the Masking-Shadowing Function. JCGT 3(2), 2014
///
/// Departs from [DLE07]: its 80 x 80 sum is 1 to 3 % low and fails at grazing angles for small m. Here half
/// vectors are sampled from the distribution itself, so that all samples have equal weight.
#pragma once

#include <vector>

namespace dermis::optics {

/// cos 0..1; two more columns hold the cosine-weighted mean
inline constexpr int directional_albedo_columns = 64;
inline constexpr int directional_albedo_rows = 32;  ///< m from directional_albedo_min_m to 1
inline constexpr double directional_albedo_min_m = 0.05;

/// Facets hide each other in one of two forms. In both Beckmann's distribution is not divided by pi.
enum class Masking {
  smith,                  ///< D F G / (4 n.l n.v), correlated by height: [WMLT07] eq. 27, [Hei14] eq. 99
  kelemen_szirmay_kalos,  ///< D F / h.h, [KSK01] eq. 6: technique `published`
};

/// Returns Smith's Lambda for Beckmann's distribution times the cosine, [WMLT07] eq. 27: finite at cosine 0.
double cosine_lambda(double cosine, double m);

/// Schlick's Fresnel is linear in F0: rho = F0 * of_f0 + rest.
struct DirectionalAlbedo {
  double of_f0 = 0, rest = 0;
  double rho(double f0) const { return f0 * of_f0 + rest; }
};

/// Returns rho(cos, m) = Int f(l, v) cos_l dl over the hemisphere with Schlick's F0 factored out,
/// dimensionless. The cosine of the view is 0..1 (at least 1e-3 is used), m is Beckmann's roughness,
/// directional_albedo_min_m to 1.
DirectionalAlbedo directional_albedo(double cosine, double m, Masking masking);

inline constexpr int directional_albedo_channels = 4;  ///< (of_f0, rest) by Masking, in its order
/// Returns directional_albedo_rows rows of directional_albedo_columns + 2 entries.
const std::vector<float>& directional_albedo_table();

}  // namespace dermis::optics
