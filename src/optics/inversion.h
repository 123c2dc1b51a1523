// SPDX-License-Identifier: MIT
// From what artists and instruments give (a reflectance and a length) back to coefficients.
// Based on: [JMLH01] sec. 2.4; [JB02] Jensen, Buhler: A Rapid Hierarchical Rendering Technique for
// Translucent Materials. SIGGRAPH 2002
#pragma once

#include <string>

#include "optics/media.h"

namespace dermis::optics {

/// Total diffuse reflectance of the classical dipole, 0 to 1, for reduced albedo 0..1 and relative index eta
/// >= 1. [JMLH01] eq. 15: R_d = (alpha'/2) (1 + exp(-(4/3) A sqrt(3 (1 - alpha')))) exp(-sqrt(3 (1 -
/// alpha'))).
double dipole_total_reflectance(double reduced_albedo, double eta);

/// The reduced albedo whose dipole reflects `total_reflectance` (0 to 1, both ends allowed), to 1e-12, by
/// bisection: R_d is monotone. [JB02] eq. 1. InputError (place `where`) outside 0..1.
double reduced_albedo_from_reflectance(double total_reflectance, double eta, const std::string& where);

/// Coefficients from reflectance and mean free path: sigma_t' = 1/l_u, sigma_s' = alpha' sigma_t', sigma_a
/// the rest; g = 0. InputError: reflectance outside 0..1, length not > 0 and finite, eta outside 1..3.
Medium medium_from_reflectance(double total_reflectance, MeanFreePath length, double eta,
                               const std::string& where);
/// The same from the diffuse mean free path: sigma_t' = 1 / (l_d sqrt(3 (1 - alpha'))) [JB02] sec. 2.
/// InputError also where the reflectance is 1: a medium without absorption has no finite diffuse mean free
/// path.
Medium medium_from_reflectance(double total_reflectance, DiffuseMeanFreePath length, double eta,
                               const std::string& where);

}  // namespace dermis::optics
