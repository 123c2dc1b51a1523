// SPDX-License-Identifier: MIT
/// Directional albedo of the specular lobe, tabulated: rho(cos, m) = int f cos dw with rho_s factored out.
/// Based on: [DLE07] GPU Gems 3, ch. 14.3.2; [KSK01]. Their 80 x 80 sum is 1 to 3 % low and breaks at grazing angles for small m;
/// here half vectors are drawn from the distribution itself, so that every sample counts alike.
#pragma once

#include <vector>

namespace dermis::optics {

inline constexpr int attenuation_columns = 64;  ///< cos 0..1, plus two columns that hold the cosine-weighted mean
inline constexpr int attenuation_rows = 32;     ///< m from attenuation_min_m to 1
inline constexpr double attenuation_min_m = 0.05;

/// Schlick's Fresnel is linear in F0: rho = F0 * of_f0 + rest.
struct Attenuation {
  double of_f0 = 0, rest = 0;
  double rho(double f0) const { return f0 * of_f0 + rest; }
};

/// cosine 0..1 (clamped to 1e-3), m > 0.
Attenuation attenuation(double cosine, double m);
/// 2 int rho(mu) mu dmu.
Attenuation mean_attenuation(double m);

/// (of_f0, rest) pairs, attenuation_rows rows of attenuation_columns + 2.
std::vector<float> attenuation_table();

}  // namespace dermis::optics
