// SPDX-License-Identifier: MIT
// Skin by its chromophores: melanin in the epidermis, blood in the dermis.
// Based on:
// [DJ06] Donner, Jensen: A Spectral BSSRDF for Shading Human Skin. EGSR 2006
// [P98]  Prahl: Tabulated Molar Extinction Coefficient for Hemoglobin in Water. omlc.org, 1998
#pragma once

#include <string>

#include "dermis/profile.h"
#include "tissue/optics/layers.h"

namespace dermis::optics {

/// Of both layers of [DJ06], matched between them.
inline constexpr double skin_eta = 1.4;
/// Strength of the surface reflection, 0 (none) to 1 (a clean boundary of that index) [DJ06] sec. 4. It
/// changes colours, and no profile.
inline constexpr double skin_oiliness = 0.3;

/// Return the absorption of pure chromophores [1/mm], wavelength 380 to 780 nm (assertion). [DJ06] sec. 3.
/// The coefficients are per mm: read so, scattering at 500 nm is 72.8 / cm, which agrees with measurements.
double eumelanin_per_mm(double nm);    ///< 6.6e10 nm^-3.33
double pheomelanin_per_mm(double nm);  ///< 2.9e14 nm^-4.75
double baseline_per_mm(double nm);     ///< 0.0244 + 8.53 exp(-(nm - 154) / 66.2): skin without either
/// Whole blood, 150 g/L: ln(10) eps 150 / 64500 / 10, eps of [P98] interpolated between its samples 2 nm
/// apart.
double oxyhaemoglobin_per_mm(double nm);
double deoxyhaemoglobin_per_mm(double nm);
/// Returns the reduced scattering of the epidermis, 14.74 nm^-0.22 + 2.2e11 nm^-4 [1/mm]; the dermis has half
/// of it. [DJ06] sec. 3.
double skin_scattering_per_mm(double nm);

/// Returns epidermis and dermis (a half-space) at one wavelength. [DJ06] eq. 1 to 6.
Layers skin_layers(const SpectralSkin& skin, double nm);

/// Returns the fraction of diffuse light from outside that enters: 1 - skin_oiliness * 2 C1(1/eta). [DJ06]
/// sec. 4 scales its surface term by oiliness.
double entering_part();

}  // namespace dermis::optics
