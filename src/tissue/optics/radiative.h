// SPDX-License-Identifier: MIT
// Exact total reflectance and transmittance of plane layers: solves the transport equation instead of
// approximating it. Says how much light returns, not where.
// Based on:
// [PGW93] Prahl, van Gemert, Welch: Determining the optical properties of turbid media by using the
//         adding-doubling method. Appl. Opt. 32, 1993
#pragma once

#include "tissue/optics/layers.h"

namespace dermis::optics {

struct Totals {
  double reflectance = 0, transmittance = 0;  ///< 0..1, fractions of the flux that entered
};

/// Returns diffuse reflectance and transmittance (including unscattered light) for a perpendicular beam, by
/// adding and doubling with 16 directions [PGW93]; isotropic scattering with the reduced coefficients; air on
/// both sides. Deterministic; within 3e-4 absolute (1e-7 for index 1, which has no critical angle); takes
/// about 0.3 ms. Throws InputError if check() does, or if the layers differ in index, which would need other
/// directions in each layer.
Totals adding_doubling(const Layers& layers, const std::string& where = "layers");
/// Does the same with 8 directions: about six times faster, within 2e-3 absolute; for searches.
Totals adding_doubling_coarse(const Layers& layers, const std::string& where = "layers");

/// Returns adding_doubling_coarse(...).reflectance of each layer of `above` on each half-space of `below`:
/// that of above[i] on below[j] at i * below.size() + j. Each layer is doubled once, so that the cost is some
/// 4 us per result. All have one index; above are finite. None may be empty.
std::vector<double> two_layers_coarse(const std::vector<Layer>& above, const std::vector<Layer>& below);

}  // namespace dermis::optics
